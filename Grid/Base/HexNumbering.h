/**
 * Numbering of the corners and faces of hexahedra and cells. Corner c has the bits cx + 2 cy + 4
 * cz; faces are numbered -x +x -y +y -z +z.
 */
#pragma once

#include <array>

namespace vfm
{

/// Corner of a VTK hexahedron for each corner by bits. The table is its own inverse.
constexpr std::array<int, 8> VtkCorner{ { 0, 1, 3, 2, 4, 5, 7, 6 } };

/// Corners (by bits) of each face, in circular order, with the normal outward.
constexpr std::array<std::array<int, 4>, 6> FaceCorners{ { { { 0, 4, 6, 2 } }, { { 1, 3, 7, 5 } },
  { { 0, 1, 5, 4 } }, { { 2, 6, 7, 3 } }, { { 0, 2, 3, 1 } }, { { 4, 5, 7, 6 } } } };

/// Returns values of corners in VTK's order.
/// @param corners  values by corner bits
template <class T>
std::array<T, 8> InVtkOrder(const std::array<T, 8>& corners)
{
  std::array<T, 8> ordered;
  for (int c = 0; c < 8; ++c)
  {
    ordered[VtkCorner[c]] = corners[c];
  }
  return ordered;
}

} // namespace vfm
