/**
 * Mesher: from blocks of cells to a mesh of every material, and all that is told of it. What the filters and the Python package share.
 */
#pragma once

#include "Input/LabelNames.h"
#include "Options/MesherOptions.h"
#include "State/CarryState.h"
#include "Summary/MeshFields.h"

#include <functional>
#include <string>
#include <vector>

namespace vfm
{

/// Which arrays of the blocks are read.
struct MesherArrays
{
  std::vector<std::string> Fractions; ///< one a material
  std::string Labels;                 ///< not empty: instead of fractions
  LabelNames Names;                   ///< of labels
  StateChoice State;
};

struct MesherInput
{
  InputLevels Levels;
  MesherArrays Arrays;
  bool StaysInPlace = false; ///< every rank meshes its own block (FindNeighbourLevels)
  std::function<void(const std::string&)> Warn; ///< called on the first rank alone
};

struct MesherResult
{
  Mesh TheMesh; ///< in space, its materials by their labels
  MeshReport Report;
  OutputState State;
  FieldArrays Fields;         ///< ListSides, ListReport, ListDomain, ListBalance
  FieldArrays MaterialFields; ///< ListMaterials, ListBalance; a row a material
};

/// Collective. Throws InputError, on all ranks alike, as CheckOptions and what it calls do, and Aborted.
MesherResult RunMesher(const MesherInput& input, const MesherOptions& options, Runtime& runtime);

} // namespace vfm
