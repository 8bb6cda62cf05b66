/**
 * ElementParts: divides elements into parts, so that their volumes can be summed by place.
 */
#pragma once

#include "Base/Vector3.h"

namespace vfm
{

/// Calls body(centre, volume) for the 8 parts of a hexahedron between halves of its coordinates.
/// Their volumes are those of their middles, scaled to the volume of the element.
/// @param x  corners in VTK's order
template <class Body>
void ForPartsOfHex(const std::array<Vector3, 8>& x, double volume, const Body& body)
{
  std::array<Vector3, 8> centres{};
  std::array<double, 8> volumes;
  double sum = 0.0;
  for (int n = 0; n < 8; ++n)
  {
    // Weights of the lower and upper sides along each axis. VTK's order of corners: 2 and 3, 6 and
    // 7 are exchanged.
    const auto weight = [n](int a, int c) { return (c ^ (c >> 1 & 1) ^ n) >> a & 1 ? 0.25 : 0.75; };
    const auto sign = [](int a, int c) { return (c ^ (c >> 1 & 1)) >> a & 1 ? 1.0 : -1.0; };
    std::array<Vector3, 3> derivatives{};
    for (int c = 0; c < 8; ++c)
    {
      const std::array<double, 3> w{ { weight(0, c), weight(1, c), weight(2, c) } };
      centres[n] = centres[n] + w[0] * w[1] * w[2] * x[c];
      for (int a = 0; a < 3; ++a)
      {
        derivatives[a] = derivatives[a] + sign(a, c) * w[(a + 1) % 3] * w[(a + 2) % 3] * x[c];
      }
    }
    volumes[n] = Dot(derivatives[0], Cross(derivatives[1], derivatives[2]));
    sum += volumes[n];
  }
  for (int n = 0; n < 8; ++n)
  {
    body(centres[n], volumes[n] / sum * volume);
  }
}

/// Calls body(centre, volume) for the 8 parts of equal volume of a tetrahedron: 4 at corners, 4 of
/// the octahedron between them.
/// @param x  corners; the last four are not used
template <class Body>
void ForPartsOfTet(const std::array<Vector3, 8>& x, double volume, const Body& body)
{
  for (int c = 0; c < 4; ++c)
  {
    const Vector3 others = x[(c + 1) % 4] + x[(c + 2) % 4] + x[(c + 3) % 4];
    body(0.625 * x[c] + 0.125 * others, volume / 8.0);
    body(0.125 * x[c] + (0.875 / 3.0) * others, volume / 8.0);
  }
}

} // namespace vfm
