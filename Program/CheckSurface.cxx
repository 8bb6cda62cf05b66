#include "CheckSurface.h"

#include "Base/DisjointSets.h"
#include "Summary/MeshFacets.h"

#include <algorithm>
#include <map>
#include <set>
#include <vector>

namespace vfm
{
namespace
{

using Points = std::vector<Index>;

/// The faces at each edge of a surface.
std::map<Points, std::vector<Index>> FindEdges(const std::vector<Points>& surface)
{
  std::map<Points, std::vector<Index>> edges;
  for (std::size_t f = 0; f < surface.size(); ++f)
  {
    const Points& corners = surface[f];
    for (std::size_t c = 0; c < corners.size(); ++c)
    {
      const Index a = corners[c], b = corners[(c + 1) % corners.size()];
      edges[{ std::min(a, b), std::max(a, b) }].push_back(static_cast<Index>(f));
    }
  }
  return edges;
}

/// Points - edges + faces of each piece of a surface.
std::map<Index, Index> FindEulerNumbers(
  const std::vector<Points>& surface, const std::map<Points, std::vector<Index>>& edges)
{
  std::vector<Index> pieces = MakeSets(surface.size());
  for (const auto& edge : edges)
  {
    for (Index face : edge.second)
    {
      Join(pieces, edge.second[0], face);
    }
  }
  std::map<Index, Index> numbers;
  std::map<Index, std::set<Index>> points;
  for (std::size_t f = 0; f < surface.size(); ++f)
  {
    const Index piece = FindRoot(pieces, static_cast<Index>(f));
    points[piece].insert(surface[f].begin(), surface[f].end());
    ++numbers[piece];
  }
  for (const auto& edge : edges)
  {
    --numbers[FindRoot(pieces, edge.second[0])];
  }
  for (const auto& piece : points)
  {
    numbers[piece.first] += static_cast<Index>(piece.second.size());
  }
  return numbers;
}

} // namespace

SurfaceCheck CheckSurface(MeshData mesh)
{
  mesh.GeometryDimension = nullptr; // faces inside the mesh are looked at, too
  Ranks alone;
  std::vector<Points> surface;
  try
  {
    const std::vector<int> oneValue(mesh.NumberOfElements, 0);
    for (const MeshFace& face : FindMeshFaces(mesh, oneValue.data(), alone))
    {
      surface.emplace_back(
        face.Points.begin(), std::find(face.Points.begin(), face.Points.end(), -1));
    }
  }
  catch (const InputError&) // of a face of more than two elements
  {
    return { false, 0, 0 };
  }
  SurfaceCheck check;
  const auto edges = FindEdges(surface);
  for (const auto& edge : edges)
  {
    check.IsConforming = check.IsConforming && edge.second.size() == 2;
  }
  for (const auto& piece : FindEulerNumbers(surface, edges))
  {
    ++check.Pieces;
    check.Spheres += piece.second == 2;
  }
  return check;
}

} // namespace vfm
