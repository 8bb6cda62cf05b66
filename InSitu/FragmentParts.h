/**
 * FragmentParts: the elements of each fragment on this rank, with nodes of their own.
 */
#pragma once

#include "Base/CartesianGrid.h"

class vtkUnstructuredGrid;

namespace vfm
{

class FragmentParts
{
public:
  /// mesh: elements of one kind with the cell array FragmentId, numbers from 1. It must outlive this.
  explicit FragmentParts(vtkUnstructuredGrid* mesh);

  struct Part
  {
    std::vector<Index> Points;   ///< of the mesh, ascending
    std::vector<Index> Elements; ///< of the mesh, ascending
  };
  /// Without elements where this rank has none of the fragment.
  Part Get(int fragment) const;

private:
  vtkUnstructuredGrid* Mesh;
  std::vector<Index> Order,
    First; // elements by fragment; of each fragment from 0 its first, and the end
};

} // namespace vfm
