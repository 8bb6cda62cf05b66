/**
 * The closed surface as TetGen is given it: checked, in a local frame; and points in its holes.
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

/// The part in a frame where it starts at 0 and its longest side is 1 to 2, without unused points.
/// The scale is a power of two: coordinates that are equal stay equal, planes of axes stay planes.
struct LocalPart
{
  Vector3 Origin{};
  int Exponent = 0;
  std::vector<Vector3> Points;
  std::vector<int> PartPoint; ///< of each point
  std::vector<Triangle> Triangles;
  double Volume = 0.0, Area = 0.0; ///< enclosed by the triangles, and theirs

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

/// Fills local. Returns what is wrong with the surface, or nothing. Crossings are not looked for.
std::string MakeLocalPart(const TetGenPart& part, LocalPart& local);

/// A point in each hole: behind the largest triangle of each component that encloses a negative volume.
std::vector<Vector3> HoleSeeds(const LocalPart& local);

/// A message with up to three numbers.
std::string Text(const char* format, double a, double b = 0.0, double c = 0.0);

} // namespace tetfill
} // namespace vfm
