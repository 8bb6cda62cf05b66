#include "Hex/ActiveHexes.h"

#include "Smoothing/ActiveMeshBuilder.h"
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

/// The points of the nodes.
std::vector<Mover> ListMovers(const CartesianGrid& grid, const std::vector<Index>& nodes,
  const PointNumbering& numbering, const Mesh& mesh)
{
  std::vector<Mover> movers;
  for (Index node : nodes)
  {
    const Index first = numbering.FirstPoint(node), end = first + numbering.PointsAt(node);
    const Index3 p = grid.Position(node);
    for (Index point = first; point < end; ++point)
    {
      movers.push_back({ point, mesh.PointIds[point], node, p, CartesianGrid::Colour(p) });
    }
  }
  return movers;
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
  ActiveMeshBuilder builder(8, mesh.PointIds.size(), ListMovers(grid, nodes, numbering, mesh));
  const std::vector<Index> hexes = builder.AddAround(mesh);
  ActiveMesh active = builder.Finish(&partition);
  active.Widths = WidthsOfCells(grid, mesh, hexes);
  active.PlacePoints(grid, mesh);
  const std::vector<int> surface = FindSurfacePoints(interface, numbering, nodes, active.PointOf);
  AttachToNodes(interface, surface, fragments, partition, active);
  return active;
}

} // namespace vfm
