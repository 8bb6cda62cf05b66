#include "Report/DomainSides.h"

#include "Report/FlatData.h"

#include <algorithm>

namespace vfm
{
namespace
{

constexpr double SideTolerance = 1e-9; // relative to the length of the domain

} // namespace

ImageFrame FrameOfDomain(const MeshData& mesh)
{
  ImageFrame frame;
  const std::vector<double> numbers = NumbersOfField(mesh.Fields, "DomainFrame");
  if (numbers.size() == frame.Axes.size() + frame.Origin.size())
  {
    std::copy_n(numbers.begin(), frame.Axes.size(), frame.Axes.begin());
    std::copy(numbers.begin() + frame.Axes.size(), numbers.end(), frame.Origin.begin());
  }
  return frame;
}

int NumberOfAxes(const MeshData& mesh)
{
  const bool isAcrossZ =
    IsFlat(mesh) && NumbersOfField(mesh.Fields, FlatAxisName) == std::vector{ 2.0 };
  return isAcrossZ && FrameOfDomain(mesh).IsIdentity() ? 2 : 3;
}

DomainSides::DomainSides(const MeshData& mesh) :
  TheMesh(mesh),
  Bounds(NumbersOfField(mesh.Fields, "DomainBounds")),
  Periods(NumbersOfField(mesh.Fields, "PeriodLengths")),
  Frame(FrameOfDomain(mesh))
{
}

bool DomainSides::IsOnSide(Index point, int side) const
{
  if (this->Bounds.size() != 6)
  {
    return false;
  }
  const int axis = side / 2;
  const double length = this->Bounds[2 * axis + 1] - this->Bounds[2 * axis];
  if (!(length > 0.0)) // the mesh is one of a plane
  {
    return false;
  }
  const double* place = this->TheMesh.Point(point);
  const Vector3 x{ { place[0], place[1], place[2] } };
  const double own = this->Frame.IsIdentity() ? x[axis] : this->Frame.ToOwn(x)[axis];
  return std::abs(own - this->Bounds[side]) <= SideTolerance * length;
}

bool DomainSides::IsPeriodic(int side) const
{
  return side != NoSide && this->Periods.size() == 3 && this->Periods[side / 2] > 0.0;
}

int DomainSides::SideOfFace(const std::array<Index, 4>& points) const
{
  for (int side = 0; side < 6; ++side)
  {
    if (std::all_of(points.begin(), points.end(),
          [&](Index point) { return point < 0 || this->IsOnSide(point, side); }))
    {
      return side;
    }
  }
  return NoSide;
}

} // namespace vfm
