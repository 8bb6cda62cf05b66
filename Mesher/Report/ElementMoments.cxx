#include "Report/ElementMoments.h"

#include "Report/ElementCorners.h"
#include "Report/FlatData.h"

namespace vfm
{
namespace
{

using Corners = std::array<Vector3, 8>;

constexpr double Gauss =
  0.57735026918962576451; // exact to degree 3 in u, v, w, the degree of both integrands

/// Reference coordinates (u, v, w) of the corners of a hexahedron in the order of VTK.
constexpr double Signs[8][3] = { { -1, -1, -1 }, { 1, -1, -1 }, { 1, 1, -1 }, { -1, 1, -1 },
  { -1, -1, 1 }, { 1, -1, 1 }, { 1, 1, 1 }, { -1, 1, 1 } };

double TripleProduct(const Vector3& a, const Vector3& b, const Vector3& c)
{
  return Dot(Cross(a, b), c);
}

ElementMoments MomentsOfTet(const Corners& p)
{
  const double volume = TripleProduct(p[1] - p[0], p[2] - p[0], p[3] - p[0]) / 6.0;
  return { volume, 0.25 * volume * (((p[0] + p[1]) + p[2]) + p[3]) };
}

/// Finds the position and the Jacobian determinant at a point of the reference cube.
void MapPoint(const Corners& p, const double (&at)[3], Vector3& position, double& determinant)
{
  Vector3 derivative[3] = {};
  position = {};
  for (int c = 0; c < 8; ++c)
  {
    const double(&s)[3] = Signs[c];
    const double f[3] = { 1.0 + s[0] * at[0], 1.0 + s[1] * at[1], 1.0 + s[2] * at[2] };
    position = position + 0.125 * f[0] * f[1] * f[2] * p[c];
    for (int a = 0; a < 3; ++a)
    {
      derivative[a] = derivative[a] + 0.125 * s[a] * f[(a + 1) % 3] * f[(a + 2) % 3] * p[c];
    }
  }
  determinant = TripleProduct(derivative[0], derivative[1], derivative[2]);
}

ElementMoments MomentsOfHex(const Corners& p)
{
  ElementMoments moments{ 0.0, {} };
  for (const double(&sign)[3] : Signs)
  {
    Vector3 position;
    double determinant;
    MapPoint(p, { Gauss * sign[0], Gauss * sign[1], Gauss * sign[2] }, position, determinant);
    moments.Volume += determinant;
    moments.Moment = moments.Moment + determinant * position;
  }
  return moments;
}

/// Returns the area and its moment of an element of a plane.
/// @param axis  across the plane
ElementMoments MomentsOfFlat(const Corners& p, int corners, int axis)
{
  ElementMoments moments{ 0.0, {} };
  for (int c = 1; c + 1 < corners; ++c)
  {
    const double area = 0.5 * Cross(p[c] - p[0], p[c + 1] - p[0])[axis];
    moments.Volume += area;
    moments.Moment = moments.Moment + (area / 3.0) * ((p[0] + p[c]) + p[c + 1]);
  }
  return moments;
}

} // namespace

std::vector<ElementMoments> FindElementMoments(const MeshData& mesh)
{
  std::vector<ElementMoments> moments(mesh.NumberOfElements);
  const ElementCorners corners(mesh);
  const bool isFlat = IsFlat(mesh);
  const int axis = isFlat ? static_cast<int>(NumbersOfField(mesh.Fields, FlatAxisName)[0]) : 0;
  for (std::size_t e = 0; e < moments.size(); ++e)
  {
    const Corners positions = corners.Find(static_cast<Index>(e));
    moments[e] = isFlat   ? MomentsOfFlat(positions, mesh.Corners, axis)
      : mesh.Corners == 4 ? MomentsOfTet(positions)
                          : MomentsOfHex(positions);
  }
  return moments;
}

} // namespace vfm
