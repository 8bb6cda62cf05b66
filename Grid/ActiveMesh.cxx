#include "ActiveMesh.h"

#include "Vector3.h"

namespace vfm
{
namespace
{

constexpr int Rings = 2;

bool IsUniform(const CartesianGrid& grid)
{
  for (int a = 0; a < 3; ++a)
  {
    for (Index i = 1; i < grid.Global().Upper[a]; ++i)
    {
      if (std::fabs(grid.Width(a, i) - grid.Width(a, 0)) > 1e-9 * grid.Width(a, 0))
      {
        return false;
      }
    }
  }
  return true;
}

Vector3 CellWidths(const CartesianGrid& grid, const Index3& cell, double scale)
{
  return (1.0 / scale) *
    Vector3{ { grid.Width(0, cell[0]), grid.Width(1, cell[1]), grid.Width(2, cell[2]) } };
}

} // namespace

ActiveMesh::ActiveMesh(const Interface& interface, const PointNumbering& numbering,
  const LabelArray& labels, const Partition& partition, const HexMesh& mesh)
{
  const CartesianGrid& grid = interface.Grid();
  const std::vector<Index> nodes = this->FindActiveNodes(interface, numbering, labels);
  std::vector<int> pointOf(mesh.PointIds.size(), -1); // -2: active, not numbered yet
  for (Index node : nodes)
  {
    const Index first = numbering.FirstPoint(node);
    for (Index p = first; p < first + numbering.PointsAt(node); ++p)
    {
      pointOf[p] = -2;
    }
  }
  this->AddHexes(grid, mesh, pointOf);
  const double scale = grid.MeanWidth();
  for (Index p : this->MeshPoint)
  {
    Vector3 x;
    for (int a = 0; a < 3; ++a)
    {
      x[a] = (mesh.Points[3 * p + a] - grid.Coordinates(a)[0]) / scale;
    }
    this->X.push_back(x);
    const int sides = grid.DomainSides(NodeOfPoint(grid, mesh.PointIds[p]));
    this->Fixed.push_back(static_cast<unsigned char>(
      ((sides & 3) != 0) | ((sides >> 2 & 3) != 0) << 1 | ((sides >> 4 & 3) != 0) << 2));
  }
  this->AddGroups(interface, nodes, numbering, partition, pointOf, mesh);
  this->ListCorners();
}

/// Mixed nodes, and the nodes of meshed cells within two cells of one; of those, the nodes of HexBox.
std::vector<Index> ActiveMesh::FindActiveNodes(
  const Interface& interface, const PointNumbering& numbering, const LabelArray& labels) const
{
  const CartesianGrid& grid = interface.Grid();
  Buffer<unsigned char> seen(grid.NumberOfEntries(), 0);
  std::vector<Index> nodes = interface.Nodes();
  for (Index node : nodes)
  {
    seen[node] = 1;
  }
  std::size_t begin = 0;
  for (int ring = 0; ring < Rings; ++ring)
  {
    for (const std::size_t end = nodes.size(); begin < end; ++begin)
    {
      const Index node = nodes[begin];
      const Index3 p = grid.Position(node);
      for (int c = 0; c < 8; ++c)
      {
        const Index3 q{ { p[0] - 1 + (c & 1), p[1] - 1 + (c >> 1 & 1), p[2] - 1 + (c >> 2 & 1) } };
        const Index cell = grid.CellOfNode(node, c);
        if (!grid.Local().Contains(q) || !numbering.IsMeshed(labels[cell]))
        {
          continue;
        }
        for (int corner = 0; corner < 8; ++corner)
        {
          const Index other = grid.NodeOfCell(cell, corner);
          if (!seen[other])
          {
            seen[other] = 1;
            nodes.push_back(other);
          }
        }
      }
    }
  }
  const IndexBox box = grid.HexBox();
  const auto isFar = [&](Index node) { return !box.Touches(grid.Position(node)); };
  nodes.erase(std::remove_if(nodes.begin(), nodes.end(), isFar), nodes.end());
  std::sort(nodes.begin(), nodes.end());
  return nodes;
}

/// The hexes with an active point, and all their points in the order of the mesh.
void ActiveMesh::AddHexes(const CartesianGrid& grid, const HexMesh& mesh, std::vector<int>& pointOf)
{
  const Index count = static_cast<Index>(mesh.HexIds.size());
  std::vector<Index> hexes;
  std::vector<unsigned char> used(mesh.PointIds.size(), 0);
  for (Index h = 0; h < count; ++h)
  {
    const Index* points = mesh.Hexes.data() + 8 * h;
    if (std::any_of(points, points + 8, [&](Index p) { return pointOf[p] == -2; }))
    {
      hexes.push_back(h);
      std::for_each(points, points + 8, [&](Index p) { used[p] = 1; });
    }
  }
  for (std::size_t p = 0; p < used.size(); ++p)
  {
    if (used[p])
    {
      this->IsActive.push_back(pointOf[p] == -2);
      pointOf[p] = static_cast<int>(this->MeshPoint.size());
      this->MeshPoint.push_back(static_cast<Index>(p));
    }
  }
  const bool uniform = IsUniform(grid);
  const double scale = grid.MeanWidth();
  for (Index h : hexes)
  {
    std::array<int, 8> corners;
    for (int c = 0; c < 8; ++c)
    {
      corners[c] = pointOf[mesh.Hexes[8 * h + VtkCorner[c]]];
    }
    this->Hexes.push_back(corners);
    if (!uniform)
    {
      this->Widths.push_back(CellWidths(grid, CellOfHex(grid, mesh.HexIds[h]), scale));
    }
  }
  if (uniform)
  {
    this->Widths.push_back(CellWidths(grid, grid.Global().Lower, scale));
  }
}

void ActiveMesh::AddGroups(const Interface& interface, const std::vector<Index>& nodes,
  const PointNumbering& numbering, const Partition& partition, const std::vector<int>& pointOf,
  const HexMesh& mesh)
{
  this->TargetNode.assign(this->X.size(), -1);
  this->SurfacePoint.assign(interface.Nodes().size(), -1);
  for (Index node : nodes)
  {
    const Index first = numbering.FirstPoint(node);
    const int count = numbering.PointsAt(node);
    const Index mixed = interface.Find(node);
    if (mixed >= 0 && pointOf[first] >= 0)
    {
      this->TargetNode[pointOf[first]] = mixed;
      this->SurfacePoint[mixed] = pointOf[first];
    }
    if (count > 0 && partition.OwnsNode(interface.Grid().Position(node)))
    {
      const Index3 p = NodeOfPoint(interface.Grid(), mesh.PointIds[first]);
      this->Colours[CartesianGrid::Colour(p)].push_back({ pointOf[first], pointOf[first] + count });
    }
  }
}

void ActiveMesh::ListCorners()
{
  this->CornerOffset.assign(this->X.size() + 1, 0);
  for (const auto& hex : this->Hexes)
  {
    for (int p : hex)
    {
      this->CornerOffset[p + 1] += this->IsActive[p];
    }
  }
  for (std::size_t p = 1; p < this->CornerOffset.size(); ++p)
  {
    this->CornerOffset[p] += this->CornerOffset[p - 1];
  }
  this->Corners.resize(this->CornerOffset.back());
  std::vector<Index> next(this->CornerOffset.begin(), this->CornerOffset.end() - 1);
  for (std::size_t h = 0; h < this->Hexes.size(); ++h)
  {
    for (int c = 0; c < 8; ++c)
    {
      const int p = this->Hexes[h][c];
      if (this->IsActive[p])
      {
        this->Corners[next[p]++] = static_cast<Index>(8 * h) + c;
      }
    }
  }
}

void ActiveMesh::CopyTo(HexMesh& mesh, const CartesianGrid& grid) const
{
  const double scale = grid.MeanWidth();
  for (std::size_t p = 0; p < this->X.size(); ++p)
  {
    for (int a = 0; a < 3; ++a)
    {
      if (this->IsActive[p] && !(this->Fixed[p] >> a & 1))
      {
        mesh.Points[3 * this->MeshPoint[p] + a] = grid.Coordinates(a)[0] + scale * this->X[p][a];
      }
    }
  }
}

} // namespace vfm
