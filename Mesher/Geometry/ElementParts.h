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

/// Returns the corners of the 8 parts of a hexahedron between halves of its coordinates.
/// @param x  corners in VTK's order
inline std::array<std::array<Vector3, 8>, 8> DivideHex(const std::array<Vector3, 8>& x)
{
  // VTK's order of corners: 2 and 3, 6 and 7 are exchanged.
  const auto bits = [](int c) { return c ^ (c >> 1 & 1); };
  std::array<Vector3, 27> lattice; // 3 x 3 x 3 points, x fastest
  for (int c = 0; c < 8; ++c)
  {
    const int n = bits(c);
    lattice[2 * (n & 1) + 6 * (n >> 1 & 1) + 18 * (n >> 2)] = x[c];
  }
  // Along x, then y, then z: the middles of the lines between points that are known.
  for (int n = 0; n < 27; n += n % 9 == 6 ? 12 : 6)
  {
    lattice[n + 1] = 0.5 * (lattice[n] + lattice[n + 2]);
  }
  for (int n = 0; n < 27; n += n % 9 == 2 ? 16 : 1)
  {
    lattice[n + 3] = 0.5 * (lattice[n] + lattice[n + 6]);
  }
  for (int n = 0; n < 9; ++n)
  {
    lattice[n + 9] = 0.5 * (lattice[n] + lattice[n + 18]);
  }
  std::array<std::array<Vector3, 8>, 8> parts;
  for (int n = 0; n < 8; ++n)
  {
    for (int c = 0; c < 8; ++c)
    {
      const int b = bits(c);
      const auto at = [n, b](int a) { return (n >> a & 1) + (b >> a & 1); };
      parts[n][c] = lattice[at(0) + 3 * at(1) + 9 * at(2)];
    }
  }
  return parts;
}

/// Returns the corners of 8 parts of a tetrahedron of equal volume: 4 at corners, 4 of the
/// octahedron between them. The last four of 8 corners are not used.
inline std::array<std::array<Vector3, 8>, 8> DivideTet(const std::array<Vector3, 8>& x)
{
  const auto middle = [&x](int c, int d) { return 0.5 * (x[c] + x[d]); };
  const std::array<Vector3, 4> ring{ { middle(0, 2), middle(1, 2), middle(1, 3), middle(0, 3) } };
  std::array<std::array<Vector3, 8>, 8> parts{};
  for (int c = 0; c < 4; ++c)
  {
    for (int d = 0; d < 4; ++d)
    {
      parts[c][d] = middle(c, d);
    }
    parts[4 + c][0] = middle(0, 1);
    parts[4 + c][1] = middle(2, 3);
    parts[4 + c][2] = ring[c];
    parts[4 + c][3] = ring[(c + 1) % 4];
  }
  return parts;
}

} // namespace vfm
