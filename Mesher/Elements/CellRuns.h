/**
 * CellRuns: hexes that are unchanged cells of a grid, as runs along x instead of arrays of a mesh.
 */
#pragma once

#include "Base/IndexBox.h"

#include <algorithm>
#include <vector>

namespace vfm
{

/// Hexes of a uniform grid that a mesh of one rank leaves out: core hexes of cells whose points
/// never move and are inside fragments. Each has the id of the core hex of its cell, the points of
/// its nodes, and the scaled Jacobian 1. The mesh holds all other hexes, with all their points.
struct CellRuns
{
  /// Cells along x of one fragment.
  struct Run
  {
    Index3 First; ///< first cell
    Index Count;
    int Material, Fragment; ///< as Mesh::Material and Mesh::Fragment
  };
  std::vector<Run> Runs; ///< ascending by CartesianGrid::CellKey

  /// Returns the number of hexes.
  Index Count() const
  {
    Index count = 0;
    for (const Run& run : this->Runs)
    {
      count += run.Count;
    }
    return count;
  }
};

} // namespace vfm
