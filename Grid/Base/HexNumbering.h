/**
 * Numbering of the corners and faces of hexahedra and cells: corners by bits, x first; faces -x +x -y +y -z +z.
 */
#pragma once

#include <array>

namespace vfm
{

/// Corner of a VTK hexahedron for each corner bit pattern, and back (the same table).
constexpr std::array<int, 8> VtkCorner{ { 0, 1, 3, 2, 4, 5, 7, 6 } };

/// Corners (bits) of face f, around it, normal outward.
constexpr std::array<std::array<int, 4>, 6> FaceCorners{ { { { 0, 4, 6, 2 } }, { { 1, 3, 7, 5 } },
  { { 0, 1, 5, 4 } }, { { 2, 6, 7, 3 } }, { { 0, 2, 3, 1 } }, { { 4, 5, 7, 6 } } } };

/// What is given by bits, in the order of VTK.
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
