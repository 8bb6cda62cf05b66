/**
 * Independent checks that elements do not overlap and that points do not coincide.
 */
#pragma once

#include "Elements/Mesh.h"

namespace vfm
{
namespace testing
{

/// Elements that overlap others.
struct ElementOverlaps
{
  Index Pairs = 0; ///< pairs of elements that overlap
  /// Deepest overlap: the length by which one element must move to leave the other, over the cube
  /// root of the smaller volume.
  double Depth = 0.0;
  std::array<Index, 2> Deepest{}; ///< element ids of the deepest pair
};

/// Finds elements that overlap. A hex is the solid of the 24 tets between its centre, the centres
/// of its faces and its edges; where those overlap, the tets of its 32 x 32 x 32 parts decide.
/// Elements with a common face, and elements without a point next to unmeshed void, are not
/// compared: positive elements fill the space around their points.
ElementOverlaps FindElementOverlaps(const Mesh& mesh);

/// Returns the number of points at the place of another point.
Index CountCoincidentPoints(const Mesh& mesh);

} // namespace testing
} // namespace vfm
