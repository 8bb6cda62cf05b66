/**
 * WholeElements: the hexes that consist of whole cells. Their corners are still at nodes of the
 * grid, and their cells contain only their material. Far from other elements, whole elements copy
 * the state of their cells.
 */
#pragma once

#include "Base/PagedArray.h"
#include "Base/Runtime.h"
#include "Elements/Mesh.h"
#include "Fractions/FractionField.h"

namespace vfm
{

/// Table of the whole elements of a mesh. Mesh, grid and fractions must outlive it.
class WholeElements
{
public:
  /// Finds the whole elements.
  /// @param mesh  elements owned by this rank; tets are never whole
  WholeElements(
    const Mesh& mesh, const CartesianGrid& grid, const FractionField& fractions, Runtime& runtime);

  /// Returns whether elements of the mesh can be whole, on any rank.
  bool CanExist() const { return this->TheMesh.HasHexes(); }
  bool IsWhole(Index element) const { return !this->Lowest.empty() && this->Lowest[element] >= 0; }
  /// Returns the cells of a whole element.
  IndexBox CellsOf(Index element) const;
  /// Returns whether a cell belongs to a whole element.
  bool Covers(Index cell) const { return this->Covered[cell]; }

private:
  bool FindBox(Index element, IndexBox& box) const;
  bool IsPure(const IndexBox& box, int material) const;

  const Mesh& TheMesh;
  const CartesianGrid& Grid;
  const FractionField& Fractions;
  // Linear index of the lowest cell of each element, -1 if it is not whole; empty for tets.
  std::vector<Index> Lowest;
  PagedArray<unsigned char> Covered; // one flag per cell
};

} // namespace vfm
