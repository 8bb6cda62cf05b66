/**
 * FragmentParts: local fragments, the elements of each fragment on this rank and their points.
 */
#pragma once

#include "Elements/Mesh.h"

#include <vector>

namespace vfm
{

/// Index of the elements of a mesh by fragment. Refers to the mesh, which must outlive it.
class FragmentParts
{
public:
  explicit FragmentParts(const Mesh& mesh);

  /// Local fragment.
  struct Part
  {
    std::vector<Index> Points;   ///< numbers of points of the mesh, ascending
    std::vector<Index> Elements; ///< numbers of elements of the mesh, ascending
  };
  /// Returns a local fragment, without elements if this rank has none.
  /// @param fragment  number of the fragment, from 1
  Part Get(int fragment) const;

private:
  const Mesh& TheMesh;
  // Elements, ordered by fragment; start of each fragment in Order, from fragment 0, then the end.
  std::vector<Index> Order, First;
};

} // namespace vfm
