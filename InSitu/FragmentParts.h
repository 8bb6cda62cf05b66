/**
 * FragmentParts: the elements of each fragment on this rank, with nodes of their own.
 */
#pragma once

#include "Mesh/Mesh.h"

#include <vector>

namespace vfm
{

class FragmentParts
{
public:
  /// mesh: must outlive this.
  explicit FragmentParts(const Mesh& mesh);

  struct Part
  {
    std::vector<Index> Points;   ///< of the mesh, ascending
    std::vector<Index> Elements; ///< of the mesh, ascending
  };
  /// Without elements where this rank has none of the fragment.
  Part Get(int fragment) const;

private:
  const Mesh& TheMesh;
  std::vector<Index> Order,
    First; // elements by fragment; of each fragment from 0 its first, and the end
};

} // namespace vfm
