/**
 * What was measured while a mesh was made.
 */
#pragma once

#include "Base/CartesianGrid.h"

#include <array>
#include <cstdint>
#include <vector>

namespace vfm
{

struct MeshReport
{
  std::vector<double>
    TargetVolume; ///< per material from 0: sum of its fractions (length units cubed)
  std::vector<double> MeshVolume;           ///< per material from 0: of its elements
  std::vector<double> FragmentTargetVolume; ///< by fragment, [0] unused
  struct Material
  {
    Index Elements = 0, Fragments = 0;
    double MinimumScaledJacobian = 0.0, MeanScaledJacobian = 0.0; ///< when asked for
  };
  std::vector<Material> Materials;            ///< from 0
  Index RemovedRegions = 0, RemovedCells = 0; ///< small ones given to what is around them
  Index ChosenCells = 0;                      ///< of the input, that were to be refined by name
  Index FlippedCells = 0; ///< labels of cells or leaves changed to make the interfaces manifold
  int ResolveRounds = 0;
  Index NumberOfFragments = 0;
  Index NumberOfSurfaces = 0, NumberOfCurves = 0, NumberOfVertices = 0;
  Index SmoothedPoints = 0; ///< that may move
  int Sweeps = 0;           ///< of smoothing, those of the volume corrections included
  Index Visits = 0;         ///< of points in them
  Index EdgePoints = 0, CornerPoints = 0; ///< on edges of interfaces, and where these meet
  double MinimumScaledJacobian = 0.0;     ///< over the elements, when asked for
  double MeanScaledJacobian = 0.0;
  double MinimumDihedralAngle = 0.0,
         MaximumDihedralAngle = 0.0;      ///< degrees, of tets, when asked for
  std::array<Index, 18> DihedralAngles{}; ///< of tets: how many in each ten degrees, when asked for
  Index RefusedParts = 0;                 ///< parts that TetGen refused and that Cells meshed
  struct Level
  {
    Index Families = 0; ///< refined to the next level
    Index AddedForBalance =
      0; ///< of those, the ones that were not asked for but that transitions need
    Index AddedForValidity = 0; ///< and the ones where no valid mesh started otherwise
    Index Cells = 0;            ///< elements that are, or are made in, whole cells of the level
  };
  std::vector<Level> Levels; ///< from the base; empty without refinements
  Index TransitionCells = 0; ///< elements of transitions
  /// In which cells between levels were refined: where labels had to be changed, or no valid mesh started.
  int LevelRounds = 0;
  struct Stage
  {
    const char* Name;
    double Seconds;
  };
  std::vector<Stage> Stages; ///< in the order they ran
};

} // namespace vfm
