/**
 * IslandList: islands of fragments that one rank solves.
 */
#pragma once

#include "Base/PairSums.h"
#include "Volumes/FindIslands.h"
#include "Volumes/LargeIsland.h"

#include <functional>

namespace vfm
{

/// Islands whose fragments and areas are all on this rank. Fragments and areas are entries of lists
/// of the caller.
class IslandList
{
public:
  /// Returns the area of a pair by its entry.
  using AreaFunction = std::function<double(int)>;

  /// Begins a new island. Its fragments are added next, ascending by their numbers over all ranks,
  /// then its pairs, ascending.
  void BeginIsland();
  /// @param entry  place of the fragment in the lists of the caller
  /// @param id  number of the fragment over all ranks
  void AddFragment(int entry, int id);
  /// @param entry  place of the pair in the list of areas of the caller
  /// @param ids  numbers of the fragments over all ranks, the lower one first; 0 is the outside
  void AddPair(int entry, const FragmentPair& ids);
  /// Ends the list and finds the coarse levels of large islands.
  /// @param largestFactored  number of fragments of an island that is factored
  void Finish(const AreaFunction& areaOf, Index largestFactored);

  /// Solves all islands.
  /// @param lack  by entry of fragments
  /// @param[in,out] mu  by entry of fragments
  void Solve(
    const AreaFunction& areaOf, const std::vector<double>& lack, std::vector<double>& mu) const;

private:
  struct Island
  {
    std::size_t FirstFragment, FirstPair;
    int System = -1; // place in Large
  };

  std::vector<double> SolveIsland(const Island& island, const Island& next,
    const AreaFunction& areaOf, const std::vector<double>& lack) const;

  std::vector<Island> Islands;
  std::vector<int> Fragments, Ids, Areas; // entries; numbers over all ranks by fragment
  std::vector<FragmentPair> Pairs;        // fragments of the island from 1
  std::vector<LargeIsland> Large;
};

} // namespace vfm
