/**
 * LevelSetup: which levels a mesh has, decided from the property Refinement, the levels of the input and its sizes.
 */
#pragma once

#include "Base/CartesianGrid.h"
#include "Options/MesherOptions.h"
#include "Ranks/Ranks.h"

#include <string>

namespace vfm
{

/// Levels are those of the input: 0 is its coarsest, negative ones are coarser than it.
struct LevelSetup
{
  int Base = 0; ///< the coarsest level of the mesh
  int Finest =
    0; ///< the level of the grid that is meshed; finer data are averaged, coarser ones divided
  bool IsUniform = false;        ///< all cells of the mesh are of the finest level
  bool TakesInputLevels = false; ///< refined where the input has finer blocks
  std::string Warning;           ///< empty, or why there are fewer levels than were asked for

  /// Of the mesh; 0 where it is uniform.
  int Refinements() const { return this->IsUniform ? 0 : this->Finest - this->Base; }
};

/// Boxes can be coarsened as often as one wants.
constexpr int AnyLevel = 62;

/// Collective: how often the boxes of all ranks can be coarsened, so that each consists of whole cells.
int CountAlignedLevels(const std::vector<IndexBox>& boxes, Ranks& ranks);

/// coordinates: nodes of the input's coarsest level; inputFinest: its finest level; maximumLevel: how many levels above the
/// coarsest of the mesh at most, -1: of the data all, by coarsening at most 3, of an image refined 1, or what chosen cells want.
/// alignment: levels by which the boxes of the ranks can be coarsened, where they are given. wishedFinest: the finest level that
/// chosen cells want to be of; 0 without any.
LevelSetup DecideLevels(Refinement how, int maximumLevel,
  const std::array<std::vector<double>, 3>& coordinates, int inputFinest, int alignment,
  int wishedFinest);

} // namespace vfm
