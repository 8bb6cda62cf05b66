/**
 * FarMatter: material of a cell that is too far from the elements of its kind to belong to them.
 */
#pragma once

#include "Base/CartesianGrid.h"

namespace vfm
{

/// A material of an owned cell of which no cell around has the label.
struct FarMatter
{
  Index Cell; ///< CartesianGrid::CellKey
  int Material;
  double Volume; ///< cubed length units
};

} // namespace vfm
