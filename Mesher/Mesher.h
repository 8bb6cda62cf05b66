/**
 * Mesher: from blocks of cells to a mesh of every material, and all that is told of it. What the filters and the Python package share.
 */
#pragma once

#include "Base/Options.h"
#include "Input/LabelNames.h"
#include "Labels/RefinementCriteria.h"
#include "State/CarryState.h"
#include "Summary/MeshFields.h"

#include <functional>
#include <string>
#include <vector>

namespace vfm
{

enum class ElementKind
{
  Hexes,
  Tets
};

/// As properties of the filters (vtkVolumeFractionMeshAlgorithm tells what they mean), with their defaults.
struct MesherOptions
{
  ElementKind Elements = ElementKind::Hexes;
  MeshOptions Mesh; ///< but Levels
  double FractionTolerance = 1e-6;
  int LabelSmoothing = 0;
  int MinimumRegionCells = 0;
  double MaximumAspectRatio = 0.0;
  ChildRule Children = ChildRule::Planes;
  Refinement Where = Refinement::InputLevels;
  int MaximumLevel = -1;
  bool FineInterfaces = true; ///< of tets always
  int FineLayers = 2;
  RefinementCriteria Criteria; ///< but Chosen and MaximumLevel
  std::string RefinementArray; ///< empty: none
  std::vector<RefinementBox> RefinementBoxes;
  ConserveOptions Conserve;
};

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
  CarriedState State;
  FieldArrays Fields;         ///< ListSides, ListReport, ListDomain, ListBalance
  FieldArrays MaterialFields; ///< ListMaterials, ListBalance; a row a material
};

/// Collective. Throws InputError, on all ranks alike, as what it calls does, and Aborted.
MesherResult RunMesher(const MesherInput& input, const MesherOptions& options, Runtime& runtime);

} // namespace vfm
