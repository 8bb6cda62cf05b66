/**
 * IslandSystem: the linear system of the shifts of interfaces, without all of it on any rank.
 *
 * An island is a set of fragments that are connected by interfaces between fragments. Islands do
 * not depend on each other. An island of one rank is solved there, and an island of several ranks
 * on one of them, its home, unless it is huge: then its ranks solve it together. The method depends
 * on the number of fragments of the island only, and all sums are exact, so the solution has the
 * same bits on any number of ranks:
 *
 *   fragments of the island    method
 *   1                          one division
 *   up to IslandBounds         factorization (SolveForLack)
 *   more                       conjugate gradients (LargeIsland)
 */
#pragma once

#include "Base/PairSums.h"
#include "Volumes/IslandList.h"

namespace vfm
{

/// Largest numbers of fragments of an island.
struct IslandBounds
{
  Index Factored = 2000; ///< that is factored: conjugate gradients take less time from about 1,000
  Index AtHome = 20000;  ///< of several ranks that one of them solves
};

/// The system of the fragments of this rank, which are numbered as in its share.
class IslandSystem
{
public:
  IslandSystem() = default;
  /// Finds the islands.
  /// @param share  must outlive this object
  /// @param mine  areas of the interfaces of this rank
  /// @param bounds  equal on all ranks
  /// @pre Collective.
  IslandSystem(const FragmentShare& share, const PairSumMap& mine, const IslandBounds& bounds = {});

  /// Returns the areas of this rank's pairs over all ranks, ascending by pair.
  /// @param mine  areas of this rank, of the pairs that the constructor got
  /// @param[in,out] sums  sums of this rank per fragment, which become those over all ranks in the
  ///   same messages; [0] stays
  /// @pre Collective.
  std::vector<PairSum> SumAreas(const PairSumMap& mine, std::vector<ExactSum>& sums) const;

  /// Solves sum_b A_ab (mu_a - mu_b) + 1e-6 mu_a = lack_a for all fragments, with mu_0 = 0.
  /// @param areas  SumAreas
  /// @param lack  per fragment of this rank, equal on all ranks that share it; [0] is not used
  /// @return mu per fragment of this rank; [0] is 0
  /// @pre Collective.
  std::vector<double> Solve(
    const std::vector<PairSum>& areas, const std::vector<double>& lack) const;

private:
  /// Fragments and areas of islands that are solved at their homes: (island, fragment, fragment) is
  /// a fragment, (island, first, second) a pair, by numbers over all ranks.
  using Key = std::array<Index, 3>;
  /// An island that its ranks solve together.
  struct CommonIsland
  {
    std::vector<int> Fragments, Pairs; // of this rank
    LargeIsland System;
  };
  enum class Place : unsigned char
  {
    Here,
    Home,
    Common
  };

  void ListHere(const Islands& islands, const std::vector<PairSum>& areas, Index largestFactored);
  void ListHomes(const Islands& islands, const std::vector<PairSum>& areas, Index largestFactored);
  void ListAtHome(const std::vector<double>& areas, Index largestFactored);
  void ListCommon(const Islands& islands, const std::vector<PairSum>& areas);
  void AddCommon(const std::function<bool(std::size_t)>& isIn, const std::vector<PairSum>& areas);
  std::vector<double> SendHome(
    const std::vector<PairSum>& areas, const std::vector<double>& lack) const;
  void SolveAtHomes(const std::vector<PairSum>& areas, const std::vector<double>& lack,
    std::vector<double>& mu) const;

  const FragmentShare* Share = nullptr;
  PairShare Pairs;
  std::vector<Place> Places;                 // of the island of each fragment
  IslandList Here;                           // its items are fragments
  KeyMerge<Key> Ways;                        // of islands solved at their homes
  std::vector<int> KeyOfFragment, KeyOfPair; // places in the keys of this rank, -1: none
  std::size_t NumberOfKeys = 0;
  IslandList AtHome; // islands whose home is this rank; its items are keys
  std::vector<CommonIsland> Common;
};

} // namespace vfm
