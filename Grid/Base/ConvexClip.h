/**
 * Convex polyhedra cut by planes: exact volumes of boxes under any number of half-spaces.
 */
#pragma once

#include "Base/CartesianGrid.h"

#include <cstddef>
#include <vector>

namespace vfm
{

/// Points with Normal . x <= Offset; Normal has length 1 and points out.
struct HalfSpace
{
  Vector3 Normal;
  double Offset;
};

/// The faces one after another, each its corners counter-clockwise seen from outside; corners are
/// repeated in every face they belong to.
struct ConvexPiece
{
  std::vector<Vector3> Points;
  std::vector<std::size_t> Ends; ///< of each face in Points

  bool IsEmpty() const { return this->Ends.empty(); }
  void Clear()
  {
    this->Points.clear();
    this->Ends.clear();
  }
};

ConvexPiece MakeBoxPiece(const Vector3& lower, const Vector3& upper);

double ComputeVolume(const ConvexPiece& piece);

/// Cuts the piece in two; a part of no extent is empty. section: the polygon of the cut,
/// counter-clockwise about the normal of the plane, empty when the plane misses the piece.
void ClipPiece(const ConvexPiece& piece, const HalfSpace& plane, ConvexPiece& inside,
  ConvexPiece& outside, std::vector<Vector3>& section);

} // namespace vfm
