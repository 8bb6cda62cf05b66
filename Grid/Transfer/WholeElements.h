/**
 * Elements that are whole cells: nothing has moved their corners from nodes of the grid, and their cells hold their material alone.
 * Away from all others such elements take what is in their cells.
 */
#pragma once

#include "Base/PagedArray.h"
#include "Base/Runtime.h"
#include "Fractions/FractionField.h"
#include "Mesh/Mesh.h"

namespace vfm
{

class WholeElements
{
public:
  WholeElements(
    const Mesh& mesh, const CartesianGrid& grid, const FractionField& fractions, Runtime& runtime);

  bool IsWhole(Index element) const { return this->Lowest[element] >= 0; }
  /// The cells that a whole element is.
  IndexBox CellsOf(Index element) const;
  /// Whether a cell is, or is part of, a whole element.
  bool Covers(Index cell) const { return this->Covered[cell]; }

private:
  bool FindBox(Index element, IndexBox& box) const;
  bool IsPure(const IndexBox& box, int material) const;

  const Mesh& TheMesh;
  const CartesianGrid& Grid;
  const FractionField& Fractions;
  std::vector<Index>
    Lowest; // of the cells of an element, its place in the grid's box; -1: not whole
  PagedArray<unsigned char> Covered; // by cell
};

} // namespace vfm
