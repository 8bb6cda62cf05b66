/**
 * ElementFaces: the faces of hexahedra and tetrahedra, numbered as vtkHexahedron and vtkTetra number them.
 */
#pragma once

#include "Base/IndexBox.h"

#include <algorithm>

namespace vfm
{

/// The points of a face in ascending order; the first of a triangle is -1.
using FaceIds = std::array<Index, 4>;

/// The faces of the elements with 8 or 4 corners.
struct ElementFaces
{
  explicit ElementFaces(int corners) :
    Count(corners == 8 ? 6 : 4), Corners(corners == 8 ? 4 : 3), Table(corners == 8 ? OfHex : OfTet)
  {
  }

  /// The points around a face of an element, seen from outside counterclockwise; the last of a triangle is -1.
  std::array<Index, 4> PointsOf(const Index* element, int face) const
  {
    std::array<Index, 4> points{ { -1, -1, -1, -1 } };
    std::transform(this->Table[face], this->Table[face] + this->Corners, points.begin(),
      [element](int corner) { return element[corner]; });
    return points;
  }

  const int Count, Corners; ///< faces of an element, corners of a face

private:
  static constexpr int OfHex[6][4] = { { 0, 4, 7, 3 }, { 1, 2, 6, 5 }, { 0, 1, 5, 4 },
    { 3, 7, 6, 2 }, { 0, 3, 2, 1 }, { 4, 5, 6, 7 } };
  static constexpr int OfTet[4][4] = { { 0, 1, 3, -1 }, { 1, 2, 3, -1 }, { 2, 0, 3, -1 },
    { 0, 2, 1, -1 } };
  const int (*Table)[4];
};

} // namespace vfm
