/**
 * Grains: made-up fragments with interfaces, distributed to ranks.
 */
#pragma once

#include "Base/PairSums.h"
#include "Labels/FragmentShare.h"
#include "Volumes/IslandSystem.h"

#include <functional>

namespace vfm
{
namespace testing
{

/// Fragments 1 to Count and the areas between them; 0 is the outside.
struct Grains
{
  int Count = 0;
  std::vector<PairSum> Areas;        ///< each pair once
  std::vector<double> Lack;          ///< by fragment, [0] unused
  std::function<int(int, int)> Home; ///< rank of a fragment, of a number of ranks

  void Add(int a, int b, double area);
  /// Adds the grains of another group, which do not touch these.
  void Append(const Grains& others);
  /// Draws lacks between -1 and 1.
  void DrawLacks(int seed);
};

/// Returns n^3 grains on a lattice, each with up to 14 neighbours. Ranks have boxes of grains.
/// @param void  whether the outside surrounds the lattice
Grains MakeLattice(int n, bool hasVoid, int seed = 1);

/// Returns the grains of a rank: those that are at home there, and their neighbours.
FragmentShare ShareOf(const Grains& grains, Ranks& ranks);
/// Returns the areas of the rank: each rank of a grain has half of the area of its interfaces.
PairSumMap AreasOf(const Grains& grains, const FragmentShare& share);

/// Grains of one island as their ranks hold them.
struct GrainLevel
{
  IslandLevel Level;
  std::vector<double> Areas; ///< by pair of the rank, over all ranks
  std::vector<double> Lack;  ///< by grain of the rank
};
GrainLevel MakeGrainLevel(const Grains& grains, Ranks& ranks);
/// Returns values of all grains, by number over all ranks.
/// @param values  by grain of the share, equal on all ranks that share it
std::vector<double> GatherValues(const FragmentShare& share, const std::vector<double>& values);

/// Solves the system of the grains on a number of ranks that are threads.
/// @return mu per grain
std::vector<double> SolveOnRanks(const Grains& grains, int count, const IslandBounds& bounds = {});
/// Returns the largest |lack - sum of areas times differences of mu - 1e-6 mu|.
double LargestResidual(const Grains& grains, const std::vector<double>& mu);

} // namespace testing
} // namespace vfm
