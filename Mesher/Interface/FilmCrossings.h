/**
 * FilmCrossings: crossings of films that are thinner than a cell, from the layer that best fits the
 * fractions around.
 *
 * CrossingFinder takes normals from gradients, which are of no use where a material has two
 * surfaces within a cell or two. Here both surfaces are found at once (LayerFit.h). They are exact
 * for flat films. Threads keep the crossings of CrossingFinder: a cylinder that fits the fractions
 * around gave volumes that are farther off.
 */
#pragma once

#include "Fractions/LayerFit.h"
#include "Interface/Interface.h"

#include <optional>

namespace vfm
{

/// The films in and beside thin cells. It does not change after construction, so threads may share
/// it. Keeps references to grid and labels.
class FilmCrossings
{
public:
  /// Fits a layer in each cell that has faces and the label of a thin cell among the 27 around it.
  /// @param thin  cells that got their label as a part of a film, thread or drop, ascending
  FilmCrossings(const CartesianGrid& grid, const FractionField& fractions, const LabelArray& labels,
    const std::vector<Index>& thin, Runtime& runtime);

  /// Returns the crossing of a face of a film, or nothing if no film fits well there.
  std::optional<Crossing> Find(const InterfaceFace& face) const;

private:
  /// A film in a cell, in the frame of the cell.
  struct Film
  {
    Index Cell;
    Layer Region;
  };

  const Film* FilmOf(Index cell) const;
  std::optional<Crossing> Cross(const InterfaceFace& face, bool isLower) const;

  const CartesianGrid& Grid;
  std::vector<Film> Films; // ascending by cell
};

} // namespace vfm
