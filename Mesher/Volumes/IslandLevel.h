/**
 * IslandLevel: the fragments of an island, or groups of them, and their pairs on a rank. Groups
 * have the number of one of their fragments.
 */
#pragma once

#include "Volumes/PairShare.h"

namespace vfm
{

/// Fragments or groups and their pairs. Numbers are of this rank; 0 is the outside.
struct IslandLevel
{
  FragmentShare Share;
  PairShare Pairs;
  std::vector<double> Regular; ///< diagonal without areas
  std::vector<int> GroupOf;    ///< number on the next level of each fragment or group
  std::vector<int> PairOf;     ///< pair on the next level, -1: inside a group, or not counted here
};

/// Areas and diagonal of a level, over all ranks.
struct IslandValues
{
  std::vector<double> Areas, Diagonal; ///< by pair; by fragment
};

/// Sums the diagonal.
/// @param areas  by pair of this rank, over all ranks
/// @pre Collective.
IslandValues MakeValues(const IslandLevel& level, std::vector<double> areas);

/// Makes the next level.
/// @param[in,out] level  gets its groups
/// @param groups  number over all ranks of the group of each fragment or group of this rank
/// @pre Collective. A group is connected by pairs.
IslandLevel MakeNextLevel(IslandLevel& level, const std::vector<Index>& groups);

/// Returns the values of the next level.
/// @pre Collective.
IslandValues SumValues(
  const IslandLevel& level, const IslandValues& values, const IslandLevel& next);

/// Returns the system times x. x[0] is 0.
/// @pre Collective.
std::vector<double> Multiply(
  const IslandLevel& level, const IslandValues& values, const std::vector<double>& x);

/// Returns the sum of x times y over all fragments or groups of all ranks.
/// @pre Collective.
double Dot(const FragmentShare& share, const std::vector<double>& x, const std::vector<double>& y);

/// Adds a factor times one list to another. [0], the outside, is not changed.
void AddTimes(double factor, const std::vector<double>& from, std::vector<double>& to);

/// Returns the sums of values by group.
/// @pre Collective.
std::vector<double> SumByGroup(
  const IslandLevel& level, const IslandLevel& next, const std::vector<double>& values);

} // namespace vfm
