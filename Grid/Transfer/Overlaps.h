/**
 * What parts of the elements of a mesh lie in which cells of a grid: exact volumes and first moments.
 *
 * A hex is the solid between its six faces, each the four triangles around the mean of its corners: its volume is that of
 * the trilinear hex (HexVolume.h), and hexes that share a face share its triangles, so what the cells get of a mesh without gaps
 * fills them. A tet is itself.
 */
#pragma once

#include "Base/Runtime.h"
#include "Mesh/MeasureFragments.h"

#include <vector>

namespace vfm
{

/// The part of an element in a cell.
struct OverlapPart
{
  Index Cell = 0;      ///< its place in grid.Local() (IndexInBox)
  double Volume = 0.0; ///< > 0, length units cubed
  Vector3 Centroid{};  ///< in the cell
};

/// The parts of some elements: those of element i are Parts[Offsets[i]] to Parts[Offsets[i + 1]], ascending by cell.
struct Overlaps
{
  std::vector<Index> Offsets;
  std::vector<OverlapPart> Parts;
};

/// elements: their places in the mesh. grid: may be coarser or finer than that of the mesh, its cells of any widths. What lies beyond
/// grid.Local(), or, on graded grids, more than StateReach cells from those that an element was made of (but TetGen's tets), goes to the
/// cells at the rim of these. The parts of an element depend on nothing but its corners and the coordinates
/// of the grid; their volumes sum to its volume but for rounding.
Overlaps FindOverlaps(const Mesh& mesh, const std::vector<Index>& elements,
  const CartesianGrid& grid, Runtime& runtime);

} // namespace vfm
