#include "Volumes/IslandSystem.h"

#include "Ranks/Agreement.h"

namespace vfm
{
namespace
{

std::vector<FragmentPair> PairsOf(const PairSumMap& sums)
{
  std::vector<FragmentPair> pairs;
  pairs.reserve(sums.size());
  for (const auto& sum : sums)
  {
    pairs.push_back({ { sum.first.first, sum.first.second } });
  }
  return pairs;
}

/// Returns places 0 to count - 1 for which a key is at least 0, ascending by (key, place).
template <class KeyOf>
std::vector<std::pair<int, int>> SortByKey(std::size_t count, const KeyOf& keyOf)
{
  std::vector<std::pair<int, int>> sorted;
  for (std::size_t i = 0; i < count; ++i)
  {
    if (const int key = keyOf(i); key >= 0)
    {
      sorted.emplace_back(key, static_cast<int>(i));
    }
  }
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

} // namespace

IslandSystem::IslandSystem(
  const FragmentShare& share, const PairSumMap& mine, const IslandBounds& bounds) :
  Share(&share), Pairs(share, PairsOf(mine), share.Shared), Places(share.Size(), Place::Here)
{
  const Islands islands = FindIslands(share, this->Pairs.Pairs());
  for (std::size_t f = 1; f < share.Size(); ++f)
  {
    if (islands.AreShared[f])
    {
      this->Places[f] = islands.Sizes[f] > bounds.AtHome ? Place::Common : Place::Home;
    }
  }
  std::vector<ExactSum> none(share.Size());
  const std::vector<PairSum> areas = this->SumAreas(mine, none);
  this->ListHere(islands, areas, bounds.Factored);
  this->ListHomes(islands, areas, bounds.Factored);
  this->ListCommon(islands, areas);
}

std::vector<PairSum> IslandSystem::SumAreas(
  const PairSumMap& mine, std::vector<ExactSum>& sums) const
{
  std::vector<ExactSum> ofPairs;
  ofPairs.reserve(mine.size());
  for (const auto& sum : mine)
  {
    ofPairs.push_back(sum.second);
  }
  this->Pairs.Sum(ofPairs, sums);
  std::vector<PairSum> areas;
  areas.reserve(ofPairs.size());
  for (std::size_t p = 0; p < ofPairs.size(); ++p)
  {
    const auto& [first, second] = this->Pairs.Pairs()[p];
    areas.push_back({ first, second, ofPairs[p] });
  }
  return areas;
}

void IslandSystem::ListHere(
  const Islands& islands, const std::vector<PairSum>& areas, Index largestFactored)
{
  const auto& pairs = this->Pairs.Pairs();
  const auto islandOf = [&](std::size_t f)
  { return f > 0 && this->Places[f] == Place::Here ? islands.Lowest[f] : -1; };
  const auto fragments = SortByKey(this->Share->Size(), islandOf);
  const auto sorted = SortByKey(pairs.size(), [&](std::size_t p) { return islandOf(pairs[p][1]); });
  auto pair = sorted.begin();
  for (auto fragment = fragments.begin(); fragment != fragments.end();)
  {
    const int island = fragment->first;
    this->Here.BeginIsland();
    for (; fragment != fragments.end() && fragment->first == island; ++fragment)
    {
      this->Here.AddFragment(fragment->second, this->Share->Ids[fragment->second]);
    }
    for (; pair != sorted.end() && pair->first == island; ++pair)
    {
      const auto& [a, b] = pairs[pair->second];
      this->Here.AddPair(pair->second, { { this->Share->Ids[a], this->Share->Ids[b] } });
    }
  }
  this->Here.Finish([&](int p) { return areas[p].Value.Value(); }, largestFactored);
}

void IslandSystem::ListHomes(
  const Islands& islands, const std::vector<PairSum>& areas, Index largestFactored)
{
  const FragmentShare& share = *this->Share;
  std::vector<Key> keys;
  for (std::size_t f = 1; f < share.Size(); ++f)
  {
    if (this->Places[f] == Place::Home)
    {
      keys.push_back({ { islands.Lowest[f], share.Ids[f], share.Ids[f] } });
    }
  }
  for (const auto& [a, b] : this->Pairs.Pairs())
  {
    if (this->Places[b] == Place::Home)
    {
      keys.push_back({ { islands.Lowest[b], share.Ids[a], share.Ids[b] } });
    }
  }
  SortUnique(keys);
  const auto placeOf = [&](int first, int second)
  {
    return static_cast<int>(
      FindSorted(keys, Key{ { islands.Lowest[second], share.Ids[first], share.Ids[second] } }));
  };
  this->KeyOfFragment.assign(share.Size(), -1);
  for (std::size_t f = 1; f < share.Size(); ++f)
  {
    const int fragment = static_cast<int>(f);
    this->KeyOfFragment[f] = this->Places[f] == Place::Home ? placeOf(fragment, fragment) : -1;
  }
  for (const auto& [a, b] : this->Pairs.Pairs())
  {
    this->KeyOfPair.push_back(this->Places[b] == Place::Home ? placeOf(a, b) : -1);
  }
  this->NumberOfKeys = keys.size();
  this->Ways = KeyMerge<Key>(keys, HomeOfFirst(*share.Group), *share.Group);
  this->ListAtHome(this->SendHome(areas, {}), largestFactored);
}

void IslandSystem::ListAtHome(const std::vector<double>& areas, Index largestFactored)
{
  const std::vector<Key>& keys = this->Ways.HomeKeys();
  const auto isSame = [](const Key& a, const Key& b) { return a[0] == b[0]; };
  ForRuns(keys.begin(), keys.end(), isSame,
    [&](auto first, auto last)
    {
      this->AtHome.BeginIsland();
      for (auto key = first; key != last; ++key)
      {
        if ((*key)[1] == (*key)[2])
        {
          this->AtHome.AddFragment(
            static_cast<int>(key - keys.begin()), static_cast<int>((*key)[1]));
        }
      }
      for (auto key = first; key != last; ++key)
      {
        if ((*key)[1] != (*key)[2])
        {
          this->AtHome.AddPair(static_cast<int>(key - keys.begin()),
            { { static_cast<int>((*key)[1]), static_cast<int>((*key)[2]) } });
        }
      }
    });
  this->AtHome.Finish([&](int key) { return areas[key]; }, largestFactored);
}

/// Sends areas and lacks of islands to their homes.
/// @return area or lack by key of this home
std::vector<double> IslandSystem::SendHome(
  const std::vector<PairSum>& areas, const std::vector<double>& lack) const
{
  std::vector<double> values(this->NumberOfKeys);
  for (std::size_t p = 0; p < areas.size(); ++p)
  {
    if (this->KeyOfPair[p] >= 0)
    {
      values[this->KeyOfPair[p]] = areas[p].Value.Value();
    }
  }
  for (std::size_t f = 1; f < lack.size(); ++f)
  {
    if (this->KeyOfFragment[f] >= 0)
    {
      values[this->KeyOfFragment[f]] = lack[f];
    }
  }
  // A key has the same value on all its ranks.
  return this->Ways.ToHome(std::move(values), 1, [](double&, double) {});
}

void IslandSystem::ListCommon(const Islands& islands, const std::vector<PairSum>& areas)
{
  std::vector<int> common;
  for (std::size_t f = 1; f < this->Share->Size(); ++f)
  {
    if (this->Places[f] == Place::Common)
    {
      common.push_back(islands.Lowest[f]);
    }
  }
  SortUnique(common);
  if (!this->Share->Group->Any(!common.empty()))
  {
    return;
  }
  for (int lowest : UnionOverRanks(*this->Share->Group, common))
  {
    const auto isIn = [&](std::size_t f)
    { return this->Places[f] == Place::Common && islands.Lowest[f] == lowest; };
    this->AddCommon(isIn, areas);
  }
}

/// Adds an island that its ranks solve together.
/// @param isIn  whether a fragment of this rank is in the island
void IslandSystem::AddCommon(
  const std::function<bool(std::size_t)>& isIn, const std::vector<PairSum>& areas)
{
  const FragmentShare& share = *this->Share;
  CommonIsland island;
  FragmentShare part;
  part.Group = share.Group;
  std::vector<Index> shared;
  std::vector<int> placeOf(share.Size(), 0);
  for (std::size_t f = 1; f < share.Size(); ++f)
  {
    if (!isIn(f))
    {
      continue;
    }
    placeOf[f] = static_cast<int>(part.Size());
    if (share.IsShared[f])
    {
      part.Shared.push_back(placeOf[f]);
      shared.push_back(share.Ids[f]);
    }
    part.Ids.push_back(share.Ids[f]);
    part.IsMine.push_back(share.IsMine[f]);
    part.IsShared.push_back(share.IsShared[f]);
    island.Fragments.push_back(static_cast<int>(f));
  }
  part.Ways = KeyMerge<Index>(std::move(shared), *share.Group);
  std::vector<FragmentPair> pairs;
  std::vector<double> values;
  for (std::size_t p = 0; p < areas.size(); ++p)
  {
    if (placeOf[areas[p].Second] > 0)
    {
      island.Pairs.push_back(static_cast<int>(p));
      pairs.push_back({ { placeOf[areas[p].First], placeOf[areas[p].Second] } });
      values.push_back(areas[p].Value.Value());
    }
  }
  island.System = LargeIsland(std::move(part), std::move(pairs), values);
  this->Common.push_back(std::move(island));
}

std::vector<double> IslandSystem::Solve(
  const std::vector<PairSum>& areas, const std::vector<double>& lack) const
{
  std::vector<double> mu(lack.size(), 0.0);
  this->Here.Solve([&](int p) { return areas[p].Value.Value(); }, lack, mu);
  this->SolveAtHomes(areas, lack, mu);
  for (const CommonIsland& island : this->Common)
  {
    std::vector<double> values, right(1, 0.0);
    for (int p : island.Pairs)
    {
      values.push_back(areas[p].Value.Value());
    }
    for (int f : island.Fragments)
    {
      right.push_back(lack[f]);
    }
    const std::vector<double> solved = island.System.Solve(values, right);
    for (std::size_t i = 0; i < island.Fragments.size(); ++i)
    {
      mu[island.Fragments[i]] = solved[i + 1];
    }
  }
  return mu;
}

void IslandSystem::SolveAtHomes(
  const std::vector<PairSum>& areas, const std::vector<double>& lack, std::vector<double>& mu) const
{
  const std::vector<double> values = this->SendHome(areas, lack);
  std::vector<double> solved(values.size(), 0.0);
  this->AtHome.Solve([&](int key) { return values[key]; }, values, solved);
  solved = this->Ways.FromHome(std::move(solved), 1);
  for (std::size_t f = 1; f < mu.size(); ++f)
  {
    mu[f] = this->KeyOfFragment[f] >= 0 ? solved[this->KeyOfFragment[f]] : mu[f];
  }
}

} // namespace vfm
