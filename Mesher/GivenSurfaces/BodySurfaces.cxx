#include "GivenSurfaces/BodySurfaces.h"

#include "Elements/GridCoordinates.h"

#include <algorithm>

namespace vfm
{
namespace
{

/// Returns a surface in grid coordinates; it faces outwards also if axes are mirrored.
ClosedSurface Convert(ClosedSurface surface, const CartesianGrid& grid,
  const std::function<Vector3(const Vector3&)>& toAxes)
{
  for (Vector3& point : surface.Points)
  {
    const Vector3 x = toAxes ? toAxes(point) : point;
    point = ToGrid(grid, x.data());
  }
  if (MeasureVolume(surface) < 0.0)
  {
    for (PointTriangle& triangle : surface.Triangles)
    {
      std::swap(triangle[1], triangle[2]);
    }
  }
  return surface;
}

} // namespace

BodySurfaces::BodySurfaces(const InputSurfaces& surfaces, const std::vector<std::string>& names,
  const CartesianGrid& grid, double edgeAngle,
  const std::function<Vector3(const Vector3&)>& toAxes) :
  BodyOf(names.size() + 1, -1)
{
  for (const BodySurface& body : surfaces.Bodies)
  {
    const auto name = std::find(names.begin(), names.end(), body.Name);
    const int material = 1 + static_cast<int>(name - names.begin());
    if (name == names.end() || this->BodyOf[material] >= 0)
    {
      continue;
    }
    this->BodyOf[material] = static_cast<int>(this->TheBodies.size());
    ClosedSurface boundary = Convert(body.Boundary, grid, toAxes);
    SurfaceSheets sheets = FindSheets(boundary, edgeAngle);
    SurfaceSides sides = FindSides(body, sheets);
    this->TheBodies.push_back(
      { material, std::move(boundary), std::move(sheets), std::move(sides) });
  }
  for (const Index3& node : { grid.Domain().Lower, grid.Domain().Upper })
  {
    const Vector3 corner = grid.NodePoint(node);
    this->TheDomain.Add(ToGrid(grid, corner.data()));
  }
  for (int a = 0; a < 3; ++a)
  {
    this->ThePeriods[a] = grid.PeriodLength(a) / grid.MeanWidth();
  }
}

int BodySurfaces::FindOfInterface(int material, int other) const
{
  const int a = this->Find(material), b = this->Find(other);
  return a < 0 || b < 0 ? std::max(a, b) : std::min(a, b);
}

} // namespace vfm
