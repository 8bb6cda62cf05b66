#include "Summary/ElementMoments.h"

#include "Summary/DomainSides.h"

#include <algorithm>
#include <cmath>

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

/// Moves corners across joined sides.
class JoinedSides
{
public:
  explicit JoinedSides(const MeshData& mesh) :
    Lengths(
      mesh.PeriodicPartner ? std::vector<double>() : NumbersOfField(mesh.Fields, "PeriodLengths")),
    Frame(FrameOfDomain(mesh))
  {
  }

  /// Moves the corners by whole periods to where they are nearest to the first one.
  void Unwrap(Corners& corners, int count) const
  {
    for (int c = 1; !this->Lengths.empty() && c < count; ++c)
    {
      Vector3 own = this->Frame.ToOwn(corners[c]);
      const Vector3 first = this->Frame.ToOwn(corners[0]);
      for (int a = 0; a < 3; ++a)
      {
        const double length = this->Lengths[a];
        own[a] -= length > 0.0 ? length * std::round((own[a] - first[a]) / length) : 0.0;
      }
      corners[c] = this->Frame.ToSpace(own);
    }
  }

private:
  const std::vector<double> Lengths; // empty: no sides are joined
  const ImageFrame Frame;
};

} // namespace

std::vector<ElementMoments> FindElementMoments(const MeshData& mesh)
{
  std::vector<ElementMoments> moments(mesh.NumberOfElements);
  const JoinedSides sides(mesh);
  Corners corners{};
  for (std::size_t e = 0; e < moments.size(); ++e)
  {
    const Index* points = mesh.Element(static_cast<Index>(e));
    for (int c = 0; c < mesh.Corners; ++c)
    {
      std::copy_n(mesh.Point(points[c]), 3, corners[c].begin());
    }
    sides.Unwrap(corners, mesh.Corners);
    moments[e] = mesh.Corners == 4 ? MomentsOfTet(corners) : MomentsOfHex(corners);
  }
  return moments;
}

} // namespace vfm
