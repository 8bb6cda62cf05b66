/**
 * TetGenSurface: checks the closed surface, transforms it to a local frame for TetGen, and finds
 * points in its holes.
 */
#pragma once

#include "Base/Vector3.h"
#include "TetGen/TetGenFill.h"

#include <cmath>

namespace vfm
{
namespace tetfill
{

using Triangle = std::array<int, 3>;
using Tet = std::array<int, 4>;

/// Part without unused points, in a frame where its lower corner is 0 and its longest side is 1 to
/// 2. The scale is a power of two, so equal coordinates remain equal and axis-aligned planes
/// remain planes.
struct LocalPart
{
  Vector3 Origin{};
  int Exponent = 0;
  std::vector<Vector3> Points;
  std::vector<int> PartPoint; ///< index of each point in the part
  std::vector<Triangle> Triangles;
  double Volume = 0.0, Area = 0.0; ///< volume enclosed by the triangles, and their area

  Vector3 ToLocal(const Vector3& p) const
  {
    const Vector3 d = p - this->Origin;
    return { { std::ldexp(d[0], -this->Exponent), std::ldexp(d[1], -this->Exponent),
      std::ldexp(d[2], -this->Exponent) } };
  }
  Vector3 ToWorld(const Vector3& p) const
  {
    return this->Origin +
      Vector3{ { std::ldexp(p[0], this->Exponent), std::ldexp(p[1], this->Exponent),
        std::ldexp(p[2], this->Exponent) } };
  }
};

/// Checks the surface and fills local. Does not search for self-intersections.
/// @return error of the surface; empty if it is valid
std::string MakeLocalPart(const TetGenPart& part, LocalPart& local);

/// Returns a point in each hole. A hole is a component that encloses a negative volume; its point
/// is behind its largest triangle.
std::vector<Vector3> HoleSeeds(const LocalPart& local);

/// Formats a message with up to three numbers, like printf.
std::string Text(const char* format, double a, double b = 0.0, double c = 0.0);

} // namespace tetfill
} // namespace vfm
