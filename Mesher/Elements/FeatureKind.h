/**
 * FeatureKind: the kind of sharp feature of an interface on which a mesh point lies.
 */
#pragma once

namespace vfm
{

/// Sharp feature at a mesh point.
enum class FeatureKind : unsigned char
{
  None,
  Side, ///< a smooth surface next to an edge
  Edge,
  Corner
};

/// Returns whether a point is a carrier: an edge runs through it or ends there.
inline bool IsCarrier(FeatureKind kind)
{
  return kind >= FeatureKind::Edge;
}

} // namespace vfm
