/**
 * MeshReport: measurements of a mesh and of the run that made it.
 */
#pragma once

#include "Base/CartesianGrid.h"

#include <array>
#include <cstdint>
#include <vector>

namespace vfm
{

/// Measurements over all ranks. Volumes are in cubed length units of the grid. Quality is 0 unless
/// MeshSettings::ComputeQuality is set.
struct MeshReport
{
  std::vector<double> TargetVolume; ///< volume of the fractions of materials 0, 1, ...
  std::vector<double> MeshVolume;   ///< volume of the elements of materials 0, 1, ...
  /// Share of the volume of materials 0, 1, ... that is in other blocks of 4^3 cells than in the
  /// fractions, or in no element (DisplacedVolume.h).
  std::vector<double> DisplacedVolume;
  /// Fragments that this rank counts, and the volume of their fractions. Each fragment of the mesh
  /// is in the list of at least one rank; on a single rank fragment f is entry f - 1.
  struct FragmentTargets
  {
    std::vector<int> Ids; ///< ascending
    std::vector<double> Volumes;
  };
  FragmentTargets Fragments;
  struct Material
  {
    Index Elements = 0, Fragments = 0;
    double MinimumScaledJacobian = 0.0, MeanScaledJacobian = 0.0;
  };
  std::vector<Material> Materials; ///< materials from 0
  /// Body whose surface the input gives (LostSurface.h). Lengths are in mean cell widths.
  struct Body
  {
    int Material = 0;
    double Thickness = 0.0; ///< of the thinnest 5 % of the area
    double LostShare = 0.0; ///< of the area
    Index Solids = 0;       ///< closed outer surfaces in the domain
    Index LostSolids = 0;   ///< of these, those without elements
    bool IsWhole = true;    ///< neither the domain nor other bodies cut parts off
    double LostArea = 0.0;  ///< of the largest lost part; 0: there is none
    double LostLength = 0.0;
    double LostThickness = 0.0; ///< median thickness there
    Vector3 LostPlace{};        ///< a point of it, in length units of the grid
  };
  std::vector<Body> Bodies; ///< empty without surfaces
  /// Small regions that became part of their neighbours.
  Index RemovedRegions = 0, RemovedCells = 0;
  Index ChosenCells = 0;   ///< user-selected cells of the input to refine
  Index ThinPartCells = 0; ///< cells that got the label of a thin part (ThinParts.h)
  Index FlippedCells = 0;  ///< cells or leaves whose label was changed to make interfaces manifold
  std::vector<Index> LostCells;   ///< of these, those that materials 0, 1, .. lost
  std::vector<Index> GainedCells; ///< of these, those that materials 0, 1, .. gained
  int ResolveRounds = 0;
  /// Void cells between bodies that are close, which kept them apart while points moved
  /// (NarrowVoid.h); coarser cells count as finest cells.
  Index NarrowVoidCells = 0;
  Index NumberOfFragments = 0;
  Index NumberOfSurfaces = 0, NumberOfCurves = 0, NumberOfVertices = 0;
  Index SmoothedPoints = 0;               ///< points that may move
  int Sweeps = 0;                         ///< sweeps of smoothing, including volume corrections
  Index Visits = 0;                       ///< visits of points in all sweeps
  Index EdgePoints = 0, CornerPoints = 0; ///< points on edges and on corners of interfaces
  double MinimumScaledJacobian = 0.0;     ///< minimum over all elements
  double MeanScaledJacobian = 0.0;
  double MinimumDihedralAngle = 0.0, MaximumDihedralAngle = 0.0; ///< only tets; degrees
  std::array<Index, 18> DihedralAngles{}; ///< only tets: number of angles per ten degrees
  Index RefusedParts = 0;                 ///< parts that TetGen rejected and that Cells meshed
  struct Level
  {
    Index Families = 0;         ///< families refined to the next level
    Index AddedForBalance = 0;  ///< families refined only because transitions need it
    Index AddedForValidity = 0; ///< families refined because no valid mesh started otherwise
    Index Cells = 0;            ///< whole cells of the level; of tets: without finer cells beside
  };
  std::vector<Level> Levels; ///< levels from the base; empty without refinements
  Index TransitionCells = 0; ///< hexes of transitions between levels; tets: cells at finer ones
  /// Rounds that refined cells between levels because labels had to be changed or
  /// no valid mesh started.
  int LevelRounds = 0;
  struct Stage
  {
    const char* Name;
    double Seconds;
  };
  std::vector<Stage> Stages; ///< stages in the order of the run
};

} // namespace vfm
