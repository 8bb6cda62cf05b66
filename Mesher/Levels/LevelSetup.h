/**
 * LevelSetup: decides the levels of a mesh from the option Refinement and the levels and sizes of
 * the input.
 */
#pragma once

#include "Base/CartesianGrid.h"
#include "Options/MesherOptions.h"
#include "Ranks/Ranks.h"

#include <string>

namespace vfm
{

/// Levels of a mesh, numbered as in the input: 0 is its coarsest level, coarser levels
/// are negative.
struct LevelSetup
{
  int Base = 0; ///< coarsest level of the mesh
  /// Level of the grid that is meshed; finer data are averaged, coarser cells are halved.
  int Finest = 0;
  bool IsUniform = false;        ///< all cells of the mesh are of the finest level
  bool TakesInputLevels = false; ///< the mesh is refined where the input has finer blocks
  std::string Warning;           ///< empty, or why there are fewer levels than requested

  /// Returns the number of refinements of the mesh; 0 if it is uniform.
  int Refinements() const { return this->IsUniform ? 0 : this->Finest - this->Base; }
};

/// Number of levels if boxes do not limit coarsening.
constexpr int AnyLevel = 62;

/// Returns how often the boxes of all ranks can be coarsened so that each consists of whole cells.
/// @pre Collective
int CountAlignedLevels(const std::vector<IndexBox>& boxes, Ranks& ranks);

/// Decides the levels of a mesh.
/// @param maximumLevel maximum number of levels above the coarsest level of the mesh. -1: all
/// levels of the data; at most 3 by coarsening; 1 for a refined image, or as selected cells request
/// @param coordinates nodes of the coarsest level of the input
/// @param inputFinest finest level of the input
/// @param alignment levels by which the boxes of the ranks and the periods can be coarsened, or
/// AnyLevel
/// @param requestedFinest finest level that selected cells request; 0 without cells
LevelSetup DecideLevels(RefinementMode how, int maximumLevel,
  const std::array<std::vector<double>, 3>& coordinates, int inputFinest, int alignment,
  int requestedFinest);

} // namespace vfm
