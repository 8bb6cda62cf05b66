#include "Hex/ActiveHexes.h"

#include "Smoothing/Attach.h"

namespace vfm
{
namespace
{

constexpr int Rings = 2;

/// Mixed nodes, and the nodes of meshed cells within two cells of one; of those, the nodes of HexBox.
std::vector<Index> FindActiveNodes(
  const Interface& interface, const PointNumbering& numbering, const LabelArray& labels)
{
  const CartesianGrid& grid = interface.Grid();
  PagedArray<unsigned char> seen(grid, 0);
  std::vector<Index> nodes = interface.Nodes();
  for (Index node : nodes)
  {
    seen.Set(node, 1);
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
            seen.Set(other, 1);
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

/// Points that are active, of the mesh.
constexpr int NotNumbered = -2;

/// The hexes with an active point, and all their points in the order of the mesh.
void AddHexes(
  const CartesianGrid& grid, const Mesh& mesh, std::vector<int>& pointOf, ActiveMesh& active)
{
  const Index count = static_cast<Index>(mesh.ElementIds.size());
  std::vector<Index> hexes;
  std::vector<unsigned char> used(mesh.PointIds.size(), 0);
  for (Index h = 0; h < count; ++h)
  {
    const Index* points = mesh.Elements.data() + 8 * h;
    if (std::any_of(points, points + 8, [&](Index p) { return pointOf[p] == NotNumbered; }))
    {
      hexes.push_back(h);
      std::for_each(points, points + 8, [&](Index p) { used[p] = 1; });
    }
  }
  for (std::size_t p = 0; p < used.size(); ++p)
  {
    if (used[p])
    {
      active.AddPoint(grid, mesh, static_cast<Index>(p), pointOf[p] == NotNumbered);
      pointOf[p] = static_cast<int>(active.X.size()) - 1;
    }
  }
  const bool uniform = IsUniform(grid);
  active.Elements.reserve(8 * hexes.size());
  for (Index h : hexes)
  {
    for (int c = 0; c < 8; ++c)
    {
      active.Elements.push_back(pointOf[mesh.Elements[8 * h + VtkCorner[c]]]);
    }
    if (!uniform)
    {
      active.Widths.push_back(CellWidths(grid, CellOfElement(grid, mesh, mesh.ElementIds[h])));
    }
  }
  if (uniform)
  {
    active.Widths.push_back(CellWidths(grid, grid.Global().Lower));
  }
}

void AddGroups(const CartesianGrid& grid, const std::vector<Index>& nodes,
  const PointNumbering& numbering, const Partition& partition, const std::vector<int>& pointOf,
  ActiveMesh& active)
{
  for (Index node : nodes)
  {
    const Index first = numbering.FirstPoint(node);
    const int count = numbering.PointsAt(node);
    const Index3 p = grid.Position(node);
    if (count > 0 && partition.OwnsNode(p))
    {
      active.Colours[CartesianGrid::Colour(p)].push_back(
        { pointOf[first], pointOf[first] + count });
    }
  }
}

/// The point S of every interface node; -1 far from the owned cells.
std::vector<int> FindSurfacePoints(const Interface& interface, const PointNumbering& numbering,
  const std::vector<Index>& nodes, const std::vector<int>& pointOf)
{
  std::vector<int> points(interface.Nodes().size(), -1);
  for (Index node : nodes)
  {
    const Index mixed = interface.Find(node);
    if (mixed >= 0)
    {
      points[mixed] = pointOf[numbering.FirstPoint(node)];
    }
  }
  return points;
}

} // namespace

ActiveMesh MakeActiveHexes(const Interface& interface, const PointNumbering& numbering,
  const LabelArray& labels, const Fragments& fragments, const Partition& partition,
  const Mesh& mesh)
{
  const CartesianGrid& grid = interface.Grid();
  const std::vector<Index> nodes = FindActiveNodes(interface, numbering, labels);
  std::vector<int> pointOf(mesh.PointIds.size(), -1);
  for (Index node : nodes)
  {
    std::fill_n(
      pointOf.begin() + numbering.FirstPoint(node), numbering.PointsAt(node), NotNumbered);
  }
  ActiveMesh active;
  AddHexes(grid, mesh, pointOf, active);
  active.FixOnDomain(grid, mesh);
  AddGroups(grid, nodes, numbering, partition, pointOf, active);
  active.ListCorners();
  const std::vector<int> surface = FindSurfacePoints(interface, numbering, nodes, pointOf);
  AttachToNodes(interface, surface, fragments, partition, active);
  return active;
}

} // namespace vfm
