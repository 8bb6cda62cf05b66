/**
 * CutPolygon: parts of triangles between planes that are normal to the axes.
 *
 * A cut of an edge depends only on the edge and the plane, so pieces on both sides of an edge or a
 * plane have bitwise equal corners there. Therefore the pieces of a closed surface are closed too,
 * and sums over their projected areas have no error except rounding.
 */
#pragma once

#include "Base/Vector3.h"

#include <algorithm>

namespace vfm
{

struct Interval
{
  double Low, High;
};

/// Triangle cut between planes along up to three axes. It has at most nine corners, or more if
/// rounding moves corners: then each cut at most doubles their number, 3, 6, 12, 24.
struct CutPolygon
{
  CutPolygon() = default;
  CutPolygon(const CutPolygon& other) { *this = other; }
  /// Copies only the corners that there are.
  CutPolygon& operator=(const CutPolygon& other)
  {
    this->Size = other.Size;
    std::copy_n(other.Corners.begin(), other.Size, this->Corners.begin());
    return *this;
  }

  /// Returns the least and the largest coordinate of the corners.
  Interval Extent(int axis) const;

  int Size = 0;
  std::array<Vector3, 24> Corners;
};

/// Returns the part of a polygon with range.Low <= x[axis] <= range.High; its size may be 0.
CutPolygon CutBetween(const CutPolygon& polygon, int axis, const Interval& range);

} // namespace vfm
