/**
 * ElementFaces: the faces of hexahedra and tetrahedra in the numbering of
 * vtkHexahedron and vtkTetra.
 */
#pragma once

#include "Base/IndexBox.h"
#include "Elements/ElementShape.h"

#include <algorithm>

namespace vfm
{

/// Points of a face. The last point of a triangle is -1; the first one if the order is ascending.
using FaceIds = std::array<Index, 4>;

/// Faces of hexahedra or tetrahedra.
struct ElementFaces
{
  /// @param corners  corners per element, 8 or 4
  explicit ElementFaces(int corners) :
    Count(ShapeOf(corners).Faces),
    Corners(ShapeOf(corners).CornersOfFace),
    Table(AreHexes(corners) ? OfHex : OfTet)
  {
  }

  /// Returns the points of a face, counterclockwise seen from outside. The last point of
  /// a triangle is -1.
  /// @param element  points of the element in VTK's order
  FaceIds PointsOf(const Index* element, int face) const
  {
    FaceIds points{ { -1, -1, -1, -1 } };
    std::transform(this->Table[face], this->Table[face] + this->Corners, points.begin(),
      [element](int corner) { return element[corner]; });
    return points;
  }

  const int Count, Corners; ///< number of faces per element and of corners per face

private:
  static constexpr int OfHex[6][4] = { { 0, 4, 7, 3 }, { 1, 2, 6, 5 }, { 0, 1, 5, 4 },
    { 3, 7, 6, 2 }, { 0, 3, 2, 1 }, { 4, 5, 6, 7 } };
  static constexpr int OfTet[4][4] = { { 0, 1, 3, -1 }, { 1, 2, 3, -1 }, { 2, 0, 3, -1 },
    { 0, 2, 1, -1 } };
  const int (*Table)[4];
};

} // namespace vfm
