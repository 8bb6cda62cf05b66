#include "Elements/Tet/NonManifoldNodes.h"

#include "Base/DisjointSets.h"
#include "Base/Sorted.h"

#include <tuple>

namespace vfm
{
namespace
{

/// Triangle of the boundary of a material, listed at one of its points.
struct Corner
{
  int Material;
  Index Point;
  std::array<Index, 2> Others; // the other two points
  auto operator<=>(const Corner&) const = default;
};

std::vector<Corner> ListCorners(const TetTopology& topology, const TetFaces& faces)
{
  std::vector<Corner> corners;
  const Mesh& mesh = topology.Tets;
  for (const TetFace& facet : faces.Faces)
  {
    for (int c = 0; c < 3; ++c)
    {
      const Index point = facet.Points[c];
      for (Index tet : { facet.Inner, facet.Outer })
      {
        if (tet >= 0 && topology.Positions[point] == PointPosition::OnInterface)
        {
          corners.push_back({ mesh.Material[tet], point,
            { { facet.Points[(c + 1) % 3], facet.Points[(c + 2) % 3] } } });
        }
      }
    }
  }
  std::sort(corners.begin(), corners.end());
  return corners;
}

/// Checks the triangles around one point. Adds every neighbour that is not on two of them, and the
/// point itself if the triangles do not form one closed fan.
void CheckFan(const Corner* first, const Corner* last, std::vector<Index>& nonManifold)
{
  std::vector<Index> ends;
  for (const Corner* corner = first; corner != last; ++corner)
  {
    ends.insert(ends.end(), corner->Others.begin(), corner->Others.end());
  }
  std::vector<Index> rim = ends;
  SortUnique(rim);
  std::vector<Index> parent = MakeSets(rim.size());
  for (std::size_t e = 0; e < ends.size(); e += 2)
  {
    Join(parent, FindSorted(rim, ends[e]), FindSorted(rim, ends[e + 1]));
  }
  bool whole = true;
  for (std::size_t i = 0; i < rim.size(); ++i)
  {
    whole = whole && FindRoot(parent, static_cast<Index>(i)) == 0;
    if (std::count(ends.begin(), ends.end(), rim[i]) != 2)
    {
      whole = false;
      nonManifold.push_back(rim[i]);
    }
  }
  if (!whole)
  {
    nonManifold.push_back(first->Point);
  }
}

} // namespace

std::vector<Index> FindNonManifoldNodes(const TetTopology& topology, const TetFaces& faces,
  const CartesianGrid& grid, const Partition& partition)
{
  const Mesh& mesh = topology.Tets;
  const std::vector<Corner> corners = ListCorners(topology, faces);
  std::vector<Index> nonManifold;
  ForRuns(
    corners.data(), corners.data() + corners.size(),
    [](const Corner& a, const Corner& b) { return a.Material == b.Material && a.Point == b.Point; },
    [&](const Corner* first, const Corner* last)
    {
      if (partition.OwnsNode(NodeOfPoint(grid, mesh, mesh.PointIds[first->Point])))
      {
        CheckFan(first, last, nonManifold);
      }
    });
  std::vector<Index> nodes;
  for (Index point : nonManifold)
  {
    const bool isNode = SlotOfPoint(mesh.PointIds[point]) <= CentreSlot;
    if (isNode && topology.Positions[point] == PointPosition::OnInterface)
    {
      nodes.push_back(mesh.PointIds[point]);
    }
  }
  SortUnique(nodes);
  return nodes;
}

} // namespace vfm
