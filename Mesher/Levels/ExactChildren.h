/**
 * ExactChildren: the fractions of half cells from the surfaces of bodies, for cells that are
 * refined.
 */
#pragma once

#include "Base/Runtime.h"
#include "Fractions/FractionField.h"
#include "GivenSurfaces/BodySurfaces.h"

namespace vfm
{

/// Fractions in the halves of cells. Only mixed cells count whose materials all have bodies, and
/// whose fractions are those of the bodies up to rounding of floats: not those that were changed,
/// for example because small regions were removed.
class ExactChildren
{
public:
  /// @param unit  grid in whose grid coordinates the bodies are, of the same domain
  /// @param grid  of the cells, not periodic
  ExactChildren(const BodySurfaces& bodies, const CartesianGrid& unit, const CartesianGrid& grid,
    const FractionField& fractions, Runtime& runtime);

  /// Returns the fractions of the parts of a cell in its children (KnownChildren of RefineCells.h).
  std::vector<std::vector<double>> Find(const Index3& cell) const;

private:
  void AddLayers(const std::array<std::vector<double>, 3>& nodes, const BodySurfaces& bodies,
    const FractionField& fractions, const std::vector<Index>& cells, Runtime& runtime);

  const CartesianGrid& Grid;
  std::vector<Index> Cells;                             // ascending
  std::vector<std::vector<std::vector<double>>> Halves; // of each cell: of each part
};

} // namespace vfm
