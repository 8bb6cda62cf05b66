#include "Volumes/IslandList.h"

#include "Base/Sorted.h"

namespace vfm
{

void IslandList::BeginIsland()
{
  this->Islands.push_back({ this->Fragments.size(), this->Pairs.size() });
}

void IslandList::AddFragment(int entry, int id)
{
  this->Fragments.push_back(entry);
  this->Ids.push_back(id);
}

void IslandList::AddPair(int entry, const FragmentPair& ids)
{
  const auto first =
    this->Ids.begin() + static_cast<std::ptrdiff_t>(this->Islands.back().FirstFragment);
  const auto placeOf = [&](int id)
  {
    return id == 0 ? 0 : static_cast<int>(std::lower_bound(first, this->Ids.end(), id) - first) + 1;
  };
  this->Areas.push_back(entry);
  this->Pairs.push_back({ { placeOf(ids[0]), placeOf(ids[1]) } });
}

void IslandList::Finish(const AreaFunction& areaOf, Index largestFactored)
{
  this->BeginIsland(); // the end of the last one
  static Ranks alone;  // has no state
  for (std::size_t i = 0; i + 1 < this->Islands.size(); ++i)
  {
    Island& island = this->Islands[i];
    const Island& next = this->Islands[i + 1];
    const std::size_t count = next.FirstFragment - island.FirstFragment;
    if (static_cast<Index>(count) <= largestFactored)
    {
      continue;
    }
    FragmentShare share;
    share.Group = &alone;
    for (std::size_t f = island.FirstFragment; f < next.FirstFragment; ++f)
    {
      share.Ids.push_back(this->Ids[f]);
    }
    share.IsMine.assign(share.Size(), 1);
    share.IsShared.assign(share.Size(), 0);
    share.Total = static_cast<Index>(count);
    std::vector<double> areas;
    for (std::size_t p = island.FirstPair; p < next.FirstPair; ++p)
    {
      areas.push_back(areaOf(this->Areas[p]));
    }
    island.System = static_cast<int>(this->Large.size());
    this->Large.emplace_back(std::move(share),
      std::vector<FragmentPair>(this->Pairs.begin() + static_cast<std::ptrdiff_t>(island.FirstPair),
        this->Pairs.begin() + static_cast<std::ptrdiff_t>(next.FirstPair)),
      areas);
  }
}

void IslandList::Solve(
  const AreaFunction& areaOf, const std::vector<double>& lack, std::vector<double>& mu) const
{
  for (std::size_t i = 0; i + 1 < this->Islands.size(); ++i)
  {
    const Island &island = this->Islands[i], &next = this->Islands[i + 1];
    std::vector<double> right(1, 0.0);
    for (std::size_t f = island.FirstFragment; f < next.FirstFragment; ++f)
    {
      right.push_back(lack[this->Fragments[f]]);
    }
    const std::vector<double> solved = this->SolveIsland(island, next, areaOf, right);
    for (std::size_t f = island.FirstFragment; f < next.FirstFragment; ++f)
    {
      mu[this->Fragments[f]] = solved[f - island.FirstFragment + 1];
    }
  }
}

/// Solves an island.
/// @param lack  of its fragments, from 1
std::vector<double> IslandList::SolveIsland(const Island& island, const Island& next,
  const AreaFunction& areaOf, const std::vector<double>& lack) const
{
  if (lack.size() == 2)
  {
    double diagonal = RegularDiagonal;
    for (std::size_t p = island.FirstPair; p < next.FirstPair; ++p)
    {
      diagonal += areaOf(this->Areas[p]);
    }
    return { 0.0, 1.0 / diagonal * lack[1] }; // the bits of SolveForLack
  }
  if (island.System >= 0)
  {
    std::vector<double> areas;
    for (std::size_t p = island.FirstPair; p < next.FirstPair; ++p)
    {
      areas.push_back(areaOf(this->Areas[p]));
    }
    return this->Large[island.System].Solve(areas, lack);
  }
  std::vector<PairSum> sums;
  for (std::size_t p = island.FirstPair; p < next.FirstPair; ++p)
  {
    sums.push_back({ this->Pairs[p][0], this->Pairs[p][1], {} });
    sums.back().Value.Add(areaOf(this->Areas[p]));
  }
  return SolveForLack(sums, lack);
}

} // namespace vfm
