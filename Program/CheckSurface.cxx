#include "CheckSurface.h"

#include "Base/DisjointSets.h"
#include "Mesh/ElementFaces.h"

#include <algorithm>
#include <map>
#include <set>
#include <vector>

namespace vfm
{
namespace
{

using Points = std::vector<Index>;

struct Face
{
  int Elements = 0;
  Points Corners; ///< around it
};

/// By their corners in order.
std::map<Points, Face> FindFaces(const MeshData& mesh)
{
  std::map<Points, Face> faces;
  const ElementFaces table(mesh.Corners);
  for (Index e = 0; e < mesh.NumberOfElements; ++e)
  {
    for (int f = 0; f < table.Count; ++f)
    {
      const std::array<Index, 4> points = table.PointsOf(mesh.Element(e), f);
      const Points corners(points.begin(), points.begin() + table.Corners);
      Points key = corners;
      std::sort(key.begin(), key.end());
      Face& face = faces[key];
      ++face.Elements;
      face.Corners = corners;
    }
  }
  return faces;
}

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

SurfaceCheck CheckSurface(const MeshData& mesh)
{
  SurfaceCheck check;
  std::vector<Points> surface;
  for (const auto& face : FindFaces(mesh))
  {
    check.IsConforming = check.IsConforming && face.second.Elements <= 2;
    if (face.second.Elements == 1)
    {
      surface.push_back(face.second.Corners);
    }
  }
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
