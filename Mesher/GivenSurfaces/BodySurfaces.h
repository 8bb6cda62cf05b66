/**
 * BodySurfaces: the given surfaces of the labels of a run, in grid coordinates.
 */
#pragma once

#include "Base/CartesianGrid.h"
#include "Surfaces/InputSurfaces.h"
#include "Surfaces/SurfaceSheets.h"

namespace vfm
{
struct PlacedBody
{
  int Label;
  std::vector<Vector3> Points;
  std::vector<PointTriangle> Triangles;
  SurfaceSheets Sheets;
};
struct BodySide
{
  int Body;
  bool IsSecondInside;
};
class BodySurfaces
{
public:
  BodySurfaces(const InputSurfaces& surfaces, const std::vector<std::string>& names,
    const CartesianGrid& grid, double angle)
  {
    for (const BodySurface& body : surfaces.Bodies)
    {
      for (std::size_t n = 0; n < names.size(); ++n)
      {
        if (names[n] == body.Name)
        {
          PlacedBody placed{ int(n) + 1, {}, body.Boundary.Triangles,
            FindSheets(body.Boundary, angle) };
          for (const Vector3& x : body.Boundary.Points)
          {
            Vector3 y;
            for (int a = 0; a < 3; ++a)
            {
              y[a] = (x[a] - grid.Coordinates(a)[0]) / grid.MeanWidth();
            }
            placed.Points.push_back(y);
          }
          this->Bodies.push_back(placed);
        }
      }
    }
  }
  BodySide Between(int first, int second) const
  {
    for (std::size_t b = 0; b < this->Bodies.size(); ++b)
    {
      if (this->Bodies[b].Label == first)
        return { int(b), false };
      if (this->Bodies[b].Label == second)
        return { int(b), true };
    }
    return { -1, false };
  }
  std::vector<PlacedBody> Bodies;
};
} // namespace vfm
