#include "Meshes/OpenFoam/FoamLayer.h"

#include "Report/MatchFaces.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vfm
{
namespace
{

/// Returns the vector across an element whose length is the area.
Vector3 AreaVector(const MeshData& mesh, Index element)
{
  const Index* corners = mesh.Element(element);
  const auto between = [&](int from, int to)
  { return mesh.PointAt(corners[to]) - mesh.PointAt(corners[from]); };
  return 0.5 *
    (mesh.Corners == 4 ? Cross(between(0, 2), between(1, 3)) : Cross(between(0, 1), between(0, 2)));
}

/// Returns the vector from the lower to the upper points. Meshes that do not know the thickness of
/// their layer are as thick as their elements are wide.
Vector3 HeightOfLayer(const MeshData& mesh)
{
  Vector3 sum{};
  for (Index element = 0; element < mesh.NumberOfElements; ++element)
  {
    sum = sum + AreaVector(mesh, element);
  }
  const std::vector<double> thickness = NumbersOfField(mesh.Fields, FlatThicknessName);
  const double mean = Norm(sum) / static_cast<double>(mesh.NumberOfElements);
  return (thickness.size() == 1 ? thickness[0] : std::sqrt(mean)) * Unit(sum);
}

/// Returns a face with its points in the same cyclic order from the one with the lowest key.
template <class Key>
std::vector<Index> FromLowest(std::vector<Index> points, const Key& key)
{
  std::rotate(points.begin(),
    std::min_element(
      points.begin(), points.end(), [&key](Index a, Index b) { return key(a) < key(b); }),
    points.end());
  return points;
}

} // namespace

std::vector<double> PointsOfLayer(const MeshData& mesh)
{
  const Vector3 height = HeightOfLayer(mesh);
  std::vector<double> points(mesh.Points, mesh.Points + 3 * mesh.NumberOfPoints);
  for (Index i = 0; i < 3 * mesh.NumberOfPoints; ++i)
  {
    points.push_back(mesh.Points[i] + height[i % 3]);
  }
  return points;
}

std::vector<Index> PointsOfLayerFace(const FoamMesh& foam, Index face)
{
  const MeshData& mesh = foam.Mesh;
  const Index above = mesh.NumberOfPoints;
  const auto key = [&mesh, above](Index point)
  {
    const Index below = point % above;
    return std::pair(point >= above, mesh.PeriodicPartner ? mesh.PeriodicPartner[below] : below);
  };
  if (face < foam.NumberOfSides())
  {
    const FaceIds ends = PointsOfSide(mesh, SideOfNumber(mesh, foam.Sides[face]));
    return FromLowest({ ends[0], ends[1], ends[1] + above, ends[0] + above }, key);
  }
  const bool isUpper = face - foam.NumberOfSides() >= mesh.NumberOfElements;
  const Index* corners = mesh.Element(foam.Owner(face));
  std::vector<Index> points;
  for (int c = 0; c < mesh.Corners; ++c)
  {
    points.push_back(isUpper ? corners[c] + above : corners[mesh.Corners - 1 - c]);
  }
  return FromLowest(std::move(points), key);
}

} // namespace vfm
