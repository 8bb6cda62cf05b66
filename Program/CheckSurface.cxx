#include "CheckSurface.h"

#include "Base/DisjointSets.h"
#include "Elements/ElementFaces.h"
#include "Report/MatchFaces.h"
#include "Report/MeshFacets.h"

#include <algorithm>
#include <map>
#include <set>
#include <vector>

namespace vfm
{
namespace
{

using Points = std::vector<Index>; // points in the order around a face

/// Returns the faces that are on only one element.
/// @throws InputError  if a face is on more than two elements
std::vector<Points> FindSurface(MeshData mesh)
{
  mesh.GeometryDimension = nullptr; // faces inside the mesh are also searched
  const std::vector<int> oneValue(mesh.NumberOfElements, 0);
  Ranks alone;
  std::vector<Points> surface;
  for (const MeshFacet& face : FindMeshFaces(mesh, oneValue.data(), alone))
  {
    const FaceIds points = PointsOfSide(mesh, face);
    surface.emplace_back(points.begin(), std::find(points.begin(), points.end(), -1));
  }
  return surface;
}

/// Faces of the surface at an edge.
struct EdgeFaces
{
  int Count = 0;
  Index First = 0;
};

SurfaceCheck CheckFaces(const std::vector<Points>& surface)
{
  const auto count = static_cast<Index>(surface.size());
  std::vector<Index> pieces = MakeSets(surface.size());
  std::map<std::pair<Index, Index>, EdgeFaces> edges;
  for (Index f = 0; f < count; ++f)
  {
    const Points& corners = surface[f];
    for (std::size_t c = 0; c < corners.size(); ++c)
    {
      EdgeFaces& edge = edges[std::minmax(corners[c], corners[(c + 1) % corners.size()])];
      edge.First = edge.Count++ == 0 ? f : edge.First;
      Join(pieces, edge.First, f);
    }
  }
  SurfaceCheck check;
  std::map<Index, Index> eulerNumbers; // points - edges + faces of each piece
  std::set<std::pair<Index, Index>> seen;
  for (Index f = 0; f < count; ++f)
  {
    const Index piece = FindRoot(pieces, f);
    ++eulerNumbers[piece];
    for (Index point : surface[f])
    {
      eulerNumbers[piece] += seen.emplace(piece, point).second;
    }
  }
  for (const auto& [points, faces] : edges)
  {
    --eulerNumbers[FindRoot(pieces, faces.First)];
    check.IsConforming = check.IsConforming && faces.Count == 2;
  }
  for (const auto& [piece, number] : eulerNumbers)
  {
    ++check.Pieces;
    check.Spheres += number == 2;
  }
  return check;
}

} // namespace

SurfaceCheck CheckSurface(const MeshData& mesh)
{
  try
  {
    return CheckFaces(FindSurface(mesh));
  }
  catch (const InputError&)
  {
    return { false, 0, 0 };
  }
}

} // namespace vfm
