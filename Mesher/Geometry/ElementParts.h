/**
 * ElementParts: divides elements into parts, so that their volumes can be summed by place.
 */
#pragma once

#include "Base/HexNumbering.h"
#include "Base/Vector3.h"

namespace vfm
{

/// Values of a linear function between two ends at 1/4 and 3/4 of the way, and its slope.
struct Quarters
{
  Quarters(const Vector3& lower, const Vector3& upper) :
    Slope(upper - lower), At{ { lower + 0.25 * this->Slope, upper - 0.25 * this->Slope } }
  {
  }
  Vector3 Slope;
  std::array<Vector3, 2> At;
};

/// Calls body(centre, volume) for the 8 parts of a hexahedron between halves of its coordinates.
/// Their volumes are those of their middles, scaled to the volume of the element.
/// @param x  corners in VTK's order
template <class Body>
void ForPartsOfHex(const std::array<Vector3, 8>& x, double volume, const Body& body)
{
  // Interpolation along one axis after the other. Part n is in the upper half along axis a if bit a
  // of n is set.
  const std::array<std::array<Quarters, 2>, 2> edges{ { { { { x[0], x[1] }, { x[3], x[2] } } },
    { { { x[4], x[5] }, { x[7], x[6] } } } } }; // [z][y]
  std::array<Vector3, 8> centres;
  std::array<std::array<Vector3, 4>, 3> slopes; // by axis and the bits of the other two axes
  for (int i = 0; i < 2; ++i)
  {
    const Quarters lower(edges[0][0].At[i], edges[0][1].At[i]);
    const Quarters upper(edges[1][0].At[i], edges[1][1].At[i]);
    const Quarters alongY(lower.Slope, upper.Slope);
    for (int j = 0; j < 2; ++j)
    {
      const Quarters alongZ(lower.At[j], upper.At[j]);
      slopes[1][i + 2 * j] = alongY.At[j];
      slopes[2][i + 2 * j] = alongZ.Slope;
      centres[i + 2 * j] = alongZ.At[0];
      centres[i + 2 * j + 4] = alongZ.At[1];
    }
  }
  const Quarters lower(edges[0][0].Slope, edges[0][1].Slope);
  const Quarters upper(edges[1][0].Slope, edges[1][1].Slope);
  for (int j = 0; j < 2; ++j)
  {
    const Quarters alongX(lower.At[j], upper.At[j]);
    slopes[0][j] = alongX.At[0];
    slopes[0][j + 2] = alongX.At[1];
  }
  std::array<double, 8> volumes;
  double sum = 0.0;
  for (int n = 0; n < 8; ++n)
  {
    const int i = n & 1, j = n >> 1 & 1, k = n >> 2;
    volumes[n] = Dot(slopes[0][j + 2 * k], Cross(slopes[1][i + 2 * k], slopes[2][i + 2 * j]));
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
  std::array<Vector3, 27> lattice; // 3 x 3 x 3 points, x fastest
  for (int c = 0; c < 8; ++c)
  {
    const int n = VtkCorner[c];
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
      const int b = VtkCorner[c];
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
