/**
 * MesherOptions: user options of a run with defaults; OptionTable.cxx explains each.
 */
#pragma once

#include "Base/Options.h"
#include "Fractions/LevelSetRule.h"
#include "Fractions/RefineCells.h"

#include <cstdint>
#include <string>
#include <vector>

namespace vfm
{

enum class ElementKind
{
  Hexes,
  Tets
};

/// Option Refinement: where the mesh is refined. Each level of refinement halves the cells.
enum class RefinementMode
{
  Off,         ///< nowhere; all cells are of the coarsest level of the input
  InputLevels, ///< where the input has finer levels
  Automatic,   ///< where criteria or user-selected cells request it
  Coarsen,     ///< near interfaces; the finest level is that of the input
  Uniform      ///< everywhere; all cells are of the finest level
};

/// How elements get the values of state arrays.
enum class TransferMode
{
  Automatic, ///< Conserve if DensityArrays is not empty, else Copy
  Copy,      ///< an element takes the values of one cell
  Conserve   ///< the contents of the cells are distributed to the elements
};

/// Treatment of kinetic energy that is lost where velocities are averaged.
enum class LostEnergy
{
  Report,        ///< only reported
  InternalEnergy ///< added to EnergyArray
};

/// Treatment of contents that are more than one cell away from all elements of their material.
enum class Unmeshed
{
  Give,     ///< added to the nearest fragment of the material, if it is within three cells
  Drop,     ///< left out of the mesh, and reported
  Particles ///< particles (Particles.h); the volumes of fragments do not count it
};

/// Sides of a periodic mesh.
enum class Sides
{
  Flat,  ///< nodes of the sides stay in their planes
  Free,  ///< sides follow interfaces
  Joined ///< none: elements at opposite sides share nodes
};

/// Option ZeroLabel: what cells of label 0 are.
enum class ZeroLabelMeaning
{
  Void,
  Material
};

/// Option LevelSetInside: the sign of level sets in their materials.
enum class LevelSetSign
{
  Negative,
  Positive
};

/// What connects both sides of split interfaces, in files.
enum class ConnectionKind
{
  None,     ///< nothing
  Cohesive, ///< elements of zero thickness
  Contact,  ///< contact of surfaces
  Tied      ///< tied surfaces
};

/// Option WholeTables: whether every rank gets the tables of all fragments, surfaces, curves and
/// vertices of the mesh.
enum class TableMode
{
  Automatic, ///< up to LargestTable rows
  Off,       ///< a rank only has rows of what it touches
  On
};
/// Number of fragments, surfaces, curves or vertices up to which TableMode::Automatic gives whole
/// tables.
constexpr std::int64_t LargestTable = 100000;

/// Unit of a thickness.
enum class ThicknessUnit
{
  Cells,
  Length
};

/// Sides of selected interfaces with layers.
enum class LayerSide
{
  Both,
  First ///< of the first material of each pair
};

/// Options of layers of hexahedra along surfaces.
struct LayerOptions
{
  int Layers = 0; ///< 0, 1: elements are not cut
  double LayerGrowth = 1.5;
  double FirstLayer = 0.0; ///< thickness; 0: as the elements are
  ThicknessUnit FirstLayerUnit = ThicknessUnit::Cells;
  std::string LayerInterfaces; ///< pairs of materials (Modify/MaterialPairs.h); empty: all
  LayerSide LayersOn = LayerSide::Both;
  int LayerSides = 0; ///< bit a is set if sides of the domain across axis a have layers
};

/// Maximum number of halvings of a cell.
constexpr int MaximumHalvings = 10;

/// Minimum of the option MaximumAspectRatio. Smaller values would make too many cells: even at 1.1,
/// a cell can be divided into ten parts along an axis.
constexpr double SmallestAspectRatio = 1.1;

/// A box in length units of the input, in world coordinates, and the number of times that the cells
/// in it are halved.
struct RefinementBox
{
  Vector3 Lower, Upper;
  double Halvings;
};

/// Options of conservative state transfer.
struct ConserveOptions
{
  int StateOrder = 2;
  bool NodalVelocity = false;
  LostEnergy LostKineticEnergy = LostEnergy::Report;
  Unmeshed UnmeshedMaterial = Unmeshed::Give;
  bool ParticleClusters = false; ///< particles of neighbour cells become one
  double LeastParticle = 0.001;  ///< in cells; smaller particles join one in a neighbour cell
};

/// All user options. An empty name means no array or no file.
struct MesherOptions : MeshSettings, LevelSettings, ConserveOptions, LayerOptions
{
  /// Sets the defaults for users that differ from those of MeshSettings.
  MesherOptions()
  {
    this->SharpEdges = SharpEdgeMode::Automatic;
    this->ThinParts = true;
  }

  ElementKind Elements = ElementKind::Hexes;
  bool Flat = false; ///< a layer of one cell gives quads, or triangles instead of tets
  int Periodic = 0;  ///< bit a is set if the domain repeats along axis a
  Sides PeriodicSides = Sides::Flat;
  std::string SplitInterfaces; ///< pairs of materials (Modify/MaterialPairs.h)
  ConnectionKind SplitConnection = ConnectionKind::None;
  double FractionTolerance = 1e-6;
  int LabelSmoothing = 0;
  std::string LabelNames; ///< path of a file
  ZeroLabelMeaning ZeroLabel = ZeroLabelMeaning::Void;
  LevelSetRule LevelSets = LevelSetRule::Off;
  LevelSetSign LevelSetInside = LevelSetSign::Negative;
  std::string Threshold;  ///< ranges of values that are materials (ValueRanges.h); empty: labels
  bool ImageAxes = false; ///< true: the mesh is not rotated to world coordinates
  int MinimumRegionCells = 0;
  TransferMode StateTransfer = TransferMode::Automatic;
  std::vector<std::string> DensityArrays;
  std::vector<std::string> StateKinds; ///< entries name=kind
  std::string VelocityArray, EnergyArray;
  std::vector<std::string> RotatedArrays;
  std::string CellWidth = "0"; ///< widths along the axes (CellWidths.h)
  std::string MaterialWidths;  ///< widths of materials, or "auto" (MaterialWidths.h)
  double AllowedError = 0.5;   ///< of surfaces if MaterialWidths is "auto", in cells of the input
  RefinementMode Refinement = RefinementMode::InputLevels;
  int MaximumLevel = -1; ///< -1: automatic
  double ThinCells = 2.0, CurvaturePerCell = 0.0;
  bool RefineFlippedCells = false;
  int InterfaceLayers = 0;
  std::string RefinementArray;
  std::vector<RefinementBox> RefinementBoxes;
  double MaximumAspectRatio = 0.0;
  ChildRule ChildFractions = ChildRule::Planes;
  TableMode WholeTables = TableMode::Automatic;
  int NumberOfThreads = 0; ///< used by the code that creates the Runtime
};

/// Returns whether TetGen makes the elements; it needs the finest cells at all interfaces.
inline bool UsesTetGen(const MesherOptions& options)
{
  return options.Elements == ElementKind::Tets && options.Method == TetMethod::TetGen;
}

/// Returns whether every rank gets a table of this number of rows.
inline bool HasWholeTable(TableMode mode, std::int64_t rows)
{
  return mode == TableMode::On || (mode == TableMode::Automatic && rows <= LargestTable);
}

/// Returns whether the domain repeats along each axis.
inline std::array<bool, 3> RepeatingAxes(const MesherOptions& options)
{
  return { { (options.Periodic & 1) != 0, (options.Periodic & 2) != 0,
    (options.Periodic & 4) != 0 } };
}

/// Returns the name of the refinement array, or "" unless Refinement is Automatic.
inline std::string FindRefinementArray(const MesherOptions& options)
{
  return options.Refinement == RefinementMode::Automatic ? options.RefinementArray : "";
}

} // namespace vfm
