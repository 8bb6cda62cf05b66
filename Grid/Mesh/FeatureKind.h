/**
 * What a point of a mesh lies on where interfaces have edges.
 */
#pragma once

namespace vfm
{

enum class FeatureKind : unsigned char
{
  None,
  Side, ///< one of the surfaces beside an edge
  Edge,
  Corner
};

/// Whether an edge runs through a point.
inline bool IsCarrier(FeatureKind kind)
{
  return kind >= FeatureKind::Edge;
}

} // namespace vfm
