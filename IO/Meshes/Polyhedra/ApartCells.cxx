#include "Meshes/Polyhedra/ApartCells.h"

#include "Base/Vector3.h"

#include <algorithm>

namespace vfm
{
namespace
{

/// Returns the new number of a point that is added.
Index AddPoint(const Vector3& x, std::vector<double>& points)
{
  points.insert(points.end(), x.begin(), x.end());
  return static_cast<Index>(points.size()) / 3 - 1;
}

void AddNode(const MeshData& mesh, const DualWalls& walls, Index node, ApartPoints& apart,
  std::vector<double>& points)
{
  if (!apart.Nodes.count(node))
  {
    const Index onWall = walls.NodePoints[node];
    apart.Nodes[node] = onWall >= 0 ? onWall : AddPoint(mesh.PointAt(node), points);
  }
}

void AddMiddle(const MeshData& mesh, const DualWalls& walls, const EdgeIds& edge,
  ApartPoints& apart, std::vector<double>& points)
{
  if (!apart.Middles.count(edge))
  {
    const Index onWall = walls.MiddleOf(edge);
    apart.Middles[edge] = onWall >= 0
      ? onWall
      : AddPoint(0.5 * (mesh.PointAt(edge[0]) + mesh.PointAt(edge[1])), points);
  }
}

void AddCentre(const DualTets& tets, Index side, ApartPoints& apart, std::vector<double>& points)
{
  const EdgeIds pair = MakeEdgeIds(side / 4, tets.BehindSide(side));
  if (!apart.Centres.count(pair))
  {
    const MeshData& mesh = tets.Data();
    FaceIds nodes = PointsOfSide(mesh, { side / 4, static_cast<int>(side % 4) });
    std::sort(nodes.begin(), nodes.begin() + 3);
    const Vector3 sum = mesh.PointAt(nodes[0]) + mesh.PointAt(nodes[1]) + mesh.PointAt(nodes[2]);
    apart.Centres[pair] = AddPoint((1.0 / 3.0) * sum, points);
  }
}

} // namespace

ApartPoints AddApartPoints(const DualTets& tets, const DualWalls& walls,
  const std::vector<char>& isApart, std::vector<double>& points)
{
  ApartPoints apart;
  for (Index corner = 0; corner < static_cast<Index>(isApart.size()); ++corner)
  {
    if (!isApart[corner])
    {
      continue;
    }
    const Index tet = corner / 4, node = tets.Data().Elements[corner];
    AddNode(tets.Data(), walls, node, apart, points);
    for (int c = 0; c < 4; ++c)
    {
      const Index side = 4 * tet + SideByCorner[c];
      if (c != corner % 4)
      {
        AddMiddle(tets.Data(), walls, MakeEdgeIds(node, tets.Node(tet, c)), apart, points);
        if (!tets.IsWall(side))
        {
          AddCentre(tets, side, apart, points);
        }
      }
    }
  }
  return apart;
}

} // namespace vfm
