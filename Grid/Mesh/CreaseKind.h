/**
 * What a point of a mesh lies on where interfaces have edges.
 */
#pragma once

namespace vfm
{

enum class CreaseKind : unsigned char
{
  None,
  Side, ///< one of the surfaces beside an edge
  Edge,
  Corner
};

/// Whether an edge runs through a point.
inline bool IsCarrier(CreaseKind kind)
{
  return kind >= CreaseKind::Edge;
}

} // namespace vfm
