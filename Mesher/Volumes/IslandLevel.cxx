#include "Volumes/IslandLevel.h"

#include "Base/WideSum.h"

namespace vfm
{

IslandValues MakeValues(const IslandLevel& level, std::vector<double> areas)
{
  std::vector<ExactSum> sums(level.Share.Size());
  for (std::size_t p = 0; p < areas.size(); ++p)
  {
    if (level.Pairs.IsMine(p))
    {
      const auto& [a, b] = level.Pairs.Pairs()[p];
      sums[a].Add(areas[p]);
      sums[b].Add(areas[p]);
    }
  }
  IslandValues values{ std::move(areas), level.Share.Sum(std::move(sums)) };
  for (std::size_t f = 0; f < values.Diagonal.size(); ++f)
  {
    values.Diagonal[f] += level.Regular[f];
  }
  return values;
}

namespace
{

FragmentShare ShareGroups(IslandLevel& level, const std::vector<Index>& groups)
{
  const FragmentShare& share = level.Share;
  std::vector<Index> ids(groups.begin() + 1, groups.end());
  SortUnique(ids);
  FragmentShare next;
  next.Group = share.Group;
  next.Ids.insert(next.Ids.end(), ids.begin(), ids.end());
  next.IsMine.resize(next.Size(), 0);
  next.IsShared.resize(next.Size(), 0);
  level.GroupOf.assign(share.Size(), 0);
  for (std::size_t f = 1; f < share.Size(); ++f)
  {
    const int group = next.Find(static_cast<int>(groups[f]));
    level.GroupOf[f] = group;
    next.IsMine[group] |= share.IsMine[f] && share.Ids[f] == groups[f];
    next.IsShared[group] |= share.IsShared[f];
  }
  std::vector<Index> keys;
  for (std::size_t g = 1; g < next.Size(); ++g)
  {
    if (next.IsShared[g])
    {
      next.Shared.push_back(static_cast<int>(g));
      keys.push_back(next.Ids[g]);
    }
  }
  next.Ways = KeyMerge<Index>(std::move(keys), *share.Group);
  return next;
}

} // namespace

IslandLevel MakeNextLevel(IslandLevel& level, const std::vector<Index>& groups)
{
  IslandLevel next;
  next.Share = ShareGroups(level, groups);
  const auto pairOf = [&](std::size_t p)
  {
    const auto& [a, b] = level.Pairs.Pairs()[p];
    const int g = level.GroupOf[a], h = level.GroupOf[b];
    return FragmentPair{ { std::min(g, h), std::max(g, h) } };
  };
  std::vector<FragmentPair> pairs;
  for (std::size_t p = 0; p < level.Pairs.Size(); ++p)
  {
    const FragmentPair pair = pairOf(p);
    if (level.Pairs.IsMine(p) && pair[0] != pair[1])
    {
      pairs.push_back(pair);
    }
  }
  SortUnique(pairs);
  level.PairOf.assign(level.Pairs.Size(), -1);
  for (std::size_t p = 0; p < level.Pairs.Size(); ++p)
  {
    if (level.Pairs.IsMine(p))
    {
      level.PairOf[p] = static_cast<int>(FindSorted(pairs, pairOf(p)));
    }
  }
  next.Pairs = PairShare(next.Share, std::move(pairs));
  next.Regular = SumByGroup(level, next, level.Regular);
  return next;
}

IslandValues SumValues(
  const IslandLevel& level, const IslandValues& values, const IslandLevel& next)
{
  std::vector<ExactSum> sums(next.Pairs.Size());
  for (std::size_t p = 0; p < level.PairOf.size(); ++p)
  {
    if (level.PairOf[p] >= 0)
    {
      sums[level.PairOf[p]].Add(values.Areas[p]);
    }
  }
  next.Pairs.Sum(sums);
  return MakeValues(next, ValuesOf(sums));
}

std::vector<double> Multiply(
  const IslandLevel& level, const IslandValues& values, const std::vector<double>& x)
{
  std::vector<ExactSum> sums(x.size());
  for (std::size_t p = 0; p < values.Areas.size(); ++p)
  {
    if (level.Pairs.IsMine(p))
    {
      const auto& [a, b] = level.Pairs.Pairs()[p];
      ExactSum flow;
      flow.Add(values.Areas[p] * (x[b] - x[a]));
      sums[b].Add(flow);
      sums[a].Subtract(flow);
    }
  }
  for (std::size_t f = 1; f < x.size(); ++f)
  {
    if (level.Share.IsMine[f])
    {
      sums[f].Add(level.Regular[f] * x[f]);
    }
  }
  return level.Share.Sum(std::move(sums));
}

double Dot(const FragmentShare& share, const std::vector<double>& x, const std::vector<double>& y)
{
  std::vector<WideSum> sum(1); // of products, which may be smaller than an ExactSum resolves
  for (std::size_t f = 1; f < x.size(); ++f)
  {
    if (share.IsMine[f])
    {
      sum[0].Add(x[f] * y[f]);
    }
  }
  WideSum::SumOverRanks(sum, *share.Group);
  return sum[0].Value();
}

void AddTimes(double factor, const std::vector<double>& from, std::vector<double>& to)
{
  for (std::size_t f = 1; f < to.size(); ++f)
  {
    to[f] += factor * from[f];
  }
}

std::vector<double> SumByGroup(
  const IslandLevel& level, const IslandLevel& next, const std::vector<double>& values)
{
  std::vector<ExactSum> sums(next.Share.Size());
  for (std::size_t f = 1; f < values.size(); ++f)
  {
    if (level.Share.IsMine[f])
    {
      sums[level.GroupOf[f]].Add(values[f]);
    }
  }
  return next.Share.Sum(std::move(sums));
}

} // namespace vfm
