#include "Report/ElementCorners.h"

#include "Report/DomainSides.h"

#include <cmath>

namespace vfm
{
namespace
{

/// Positions are stored in quarters of the domain: those of copies differ by 3 to 5 along the axis
/// between them, and by at most 1, from rounding, along others.
constexpr int PartsOfDomain = 4;
constexpr int BitsOfAxis = 4;

} // namespace

ElementCorners::ElementCorners(const MeshData& mesh) :
  TheMesh(mesh),
  Lengths(
    mesh.PeriodicPartner ? std::vector<double>() : NumbersOfField(mesh.Fields, "PeriodLengths")),
  Frame(FrameOfDomain(mesh))
{
}

std::array<Vector3, 8> ElementCorners::Find(Index element) const
{
  std::array<Vector3, 8> corners{};
  const Index* points = this->TheMesh.Element(element);
  for (int c = 0; c < this->TheMesh.Corners; ++c)
  {
    corners[c] = this->TheMesh.PointAt(points[c]);
  }
  for (int c = 1; !this->Lengths.empty() && c < this->TheMesh.Corners; ++c)
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
  return corners;
}

FacePlaces::FacePlaces(const MeshData& mesh) :
  Bounds(NumbersOfField(mesh.Fields, "DomainBounds")), Frame(FrameOfDomain(mesh))
{
}

Index FacePlaces::Of(const std::vector<Vector3>& corners) const
{
  Vector3 sum{};
  for (const Vector3& corner : corners)
  {
    sum = sum + this->Frame.ToOwn(corner);
  }
  Index place = 0;
  for (int a = 0; a < 3; ++a)
  {
    const double low = this->Bounds[2 * a], height = this->Bounds[2 * a + 1] - low;
    const double length = height > 0.0 ? height : 1.0; // 0: across the plane of the mesh
    const double centre = sum[a] / static_cast<double>(corners.size());
    const Index part = std::llround(PartsOfDomain * (centre - low) / length) + PartsOfDomain;
    place |= part << (BitsOfAxis * a);
  }
  return place;
}

Index3 FacePlaces::PeriodsBetween(Index from, Index to)
{
  Index3 periods;
  for (int a = 0; a < 3; ++a)
  {
    const auto partOf = [a](Index place)
    { return static_cast<double>(place >> (BitsOfAxis * a) & ((1 << BitsOfAxis) - 1)); };
    periods[a] = std::llround((partOf(to) - partOf(from)) / PartsOfDomain);
  }
  return periods;
}

} // namespace vfm
