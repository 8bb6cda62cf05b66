/**
 * Convex polyhedra cut by planes: exact volumes of boxes under any number of half-spaces.
 */
#pragma once

#include "Base/CartesianGrid.h"

#include <cstddef>
#include <vector>

namespace vfm
{

/// Half-space of the points with Normal . x <= Offset. Normal has length 1 and points out.
struct HalfSpace
{
  Vector3 Normal;
  double Offset;
};

/// Convex polyhedron, stored as a list of faces. Each face lists its corners counter-clockwise,
/// seen from outside; a corner is repeated in every face that contains it.
struct ConvexPiece
{
  std::vector<Vector3> Points;
  std::vector<std::size_t> Ends; ///< end of each face in Points

  bool IsEmpty() const { return this->Ends.empty(); }
  void Clear()
  {
    this->Points.clear();
    this->Ends.clear();
  }
};

/// Returns the box between two corners.
ConvexPiece MakeBoxPiece(const Vector3& lower, const Vector3& upper);

/// Returns the volume of a piece; never negative.
double ComputeVolume(const ConvexPiece& piece);

/// Cuts a piece in two.
/// @param[out] inside,outside  the parts on both sides of the plane; a part without volume is empty
/// @param[out] section  polygon of the cut, counter-clockwise about the normal of the plane; empty
///   if the plane does not cut the piece
void ClipPiece(const ConvexPiece& piece, const HalfSpace& plane, ConvexPiece& inside,
  ConvexPiece& outside, std::vector<Vector3>& section);

} // namespace vfm
