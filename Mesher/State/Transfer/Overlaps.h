/**
 * Overlaps: cuts the elements of a mesh by the cells of a grid. Volumes and first moments of the
 * parts are exact.
 *
 * A hex is the solid between its six faces. A face consists of the four triangles around the mean
 * of its corners. The volume is that of the trilinear hex (HexVolume.h). Hexes that share a face
 * share its triangles, so the parts of a mesh without gaps fill the cells.
 */
#pragma once

#include "Base/Runtime.h"
#include "Elements/MeasureFragments.h"

#include <vector>

namespace vfm
{

/// Part of an element in a cell.
struct OverlapPart
{
  Index Cell = 0;      ///< index of the cell in grid.Local() (IndexInBox)
  double Volume = 0.0; ///< > 0, length units cubed
  Vector3 Centroid{};  ///< point in the cell
};

/// Parts of some elements. Element i has Parts[Offsets[i]] to before Parts[Offsets[i + 1]],
/// ascending by cell.
struct Overlaps
{
  std::vector<Index> Offsets;
  std::vector<OverlapPart> Parts;
};

/// Cuts elements by the cells of a grid, some at a time. It keeps its memory between calls. The
/// parts of an element depend only on its corners and the coordinates of the grid. Their volumes
/// sum to its volume, up to rounding. Parts outside grid.Local() are assigned to the cells at its
/// rim. Except for TetGen's tets, parts on graded grids that are more than StateReach cells from
/// the cells that the element was made of are assigned to the cells at this distance.
class OverlapFinder
{
public:
  /// The arguments must outlive it.
  /// @param grid  grid with cells of any widths, coarser or finer than the grid of the mesh
  OverlapFinder(const Mesh& mesh, const CartesianGrid& grid, Runtime& runtime);

  /// Cuts elements. The result is valid until the next call.
  /// @param elements  indices in the mesh
  const Overlaps& Find(const std::vector<Index>& elements);

private:
  const Mesh& TheMesh;
  const CartesianGrid& Grid;
  Runtime& Run;
  std::vector<std::vector<OverlapPart>> Pieces; // parts of consecutive elements
  Overlaps Found;
};

/// Cuts elements by the cells of a grid, like OverlapFinder.
Overlaps FindOverlaps(const Mesh& mesh, const std::vector<Index>& elements,
  const CartesianGrid& grid, Runtime& runtime);

} // namespace vfm
