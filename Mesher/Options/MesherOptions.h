/**
 * MesherOptions: what a user sets of a run, with all defaults. OptionTable.cxx names and explains each.
 */
#pragma once

#include "Base/Options.h"
#include "Fractions/RefineCells.h"

#include <string>
#include <vector>

namespace vfm
{

enum class ElementKind
{
  Hexes,
  Tets
};

/// Where the mesh is finer than elsewhere.
enum class Refinement
{
  Off,         ///< the coarsest level of the input
  InputLevels, ///< the levels of the input
  Automatic,   ///< criteria, on the coarsest level of the input
  Coarsen,     ///< the input is the finest level
  Uniform      ///< all cells are as fine as the finest
};

enum class StateTransfer
{
  Automatic, ///< Conserve where an array of density is named
  Copy,
  Conserve
};

/// What becomes of kinetic energy that is lost where velocities are averaged.
enum class LostEnergy
{
  Report,
  InternalEnergy
};

/// What becomes of material apart from all elements of its kind.
enum class Unmeshed
{
  Give, ///< to the nearest fragment of the material
  Drop
};

/// The most halvings of a cell.
constexpr int MaximumHalvings = 10;

/// The least MaximumAspectRatio. Less would multiply cells: widths within a tenth of each other take up to ten parts of a cell along an axis.
constexpr double SmallestAspectRatio = 1.1;

/// From the least to the greatest x, y, z, in the unit of the input, and how many times cells are to be halved.
struct RefinementBox
{
  Vector3 Lower, Upper;
  double Halvings;
};

/// How state is conserved.
struct ConserveOptions
{
  int StateOrder = 2;
  bool NodalVelocity = false;
  LostEnergy LostKineticEnergy = LostEnergy::Report;
  Unmeshed UnmeshedMaterial = Unmeshed::Give;
};

/// Empty names are those of no array or file.
struct MesherOptions : MeshSettings, LevelSettings, ConserveOptions
{
  MesherOptions() { this->Edges = SharpEdges::Automatic; }

  ElementKind Elements = ElementKind::Hexes;
  double FractionTolerance = 1e-6;
  int LabelSmoothing = 0;
  std::string LabelNames; ///< a file
  bool ImageAxes = false; ///< the mesh is not turned
  int MinimumRegionCells = 0;
  StateTransfer Transfer = StateTransfer::Automatic;
  std::vector<std::string> DensityArrays;
  std::vector<std::string> StateKinds; ///< words name=kind
  std::string VelocityArray, EnergyArray;
  Refinement Where = Refinement::InputLevels;
  int MaximumLevel = -1;
  double ThinCells = 2.0, CurvaturePerCell = 0.0;
  bool RefineFlippedCells = false;
  int InterfaceLayers = 0;
  std::string RefinementArray;
  std::vector<RefinementBox> RefinementBoxes;
  double MaximumAspectRatio = 0.0;
  ChildRule Children = ChildRule::Planes;
  int NumberOfThreads = 0; ///< who makes the Runtime heeds it
};

/// The array that chooses cells to refine, empty where none does.
inline std::string FindRefinementArray(const MesherOptions& options)
{
  return options.Where == Refinement::Automatic ? options.RefinementArray : "";
}

} // namespace vfm
