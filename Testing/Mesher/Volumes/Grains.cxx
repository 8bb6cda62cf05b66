#include "Grains.h"

#include "RandomDraw.h"
#include "ThreadRanks.h"

#include <gtest/gtest.h>

#include <set>

namespace vfm
{
namespace testing
{

void Grains::Add(int a, int b, double area)
{
  this->Areas.push_back({ std::min(a, b), std::max(a, b), {} });
  this->Areas.back().Value.Add(0.5 * area);
  this->Areas.back().Value.Add(0.5 * area);
}

void Grains::Append(const Grains& others)
{
  const int before = this->Count;
  for (const PairSum& area : others.Areas)
  {
    this->Areas.push_back(
      { area.First > 0 ? area.First + before : 0, area.Second + before, area.Value });
  }
  this->Lack.resize(before + 1, 0.0);
  this->Lack.insert(this->Lack.end(), others.Lack.begin() + 1, others.Lack.end());
  this->Count += others.Count;
  const auto first = std::move(this->Home), second = others.Home;
  this->Home = [=](int f, int ranks)
  { return f <= before ? first(f, ranks) : second(f - before, ranks); };
}

void Grains::DrawLacks(int seed)
{
  RandomDraw random(seed);
  this->Lack.assign(this->Count + 1, 0.0);
  for (int f = 1; f <= this->Count; ++f)
  {
    this->Lack[f] = random.Between(-1.0, 1.0);
  }
}

Grains MakeLattice(int n, bool hasVoid, int seed)
{
  Grains grains;
  grains.Count = n * n * n;
  RandomDraw random(seed);
  const auto numberOf = [n](int x, int y, int z) { return (z * n + y) * n + x + 1; };
  for (int i = 0; i < grains.Count; ++i)
  {
    const int x = i % n, y = i / n % n, z = i / (n * n);
    for (int d = 0; d < 27; ++d)
    {
      const int dx = d % 3 - 1, dy = d / 3 % 3 - 1, dz = d / 9 - 1;
      const int X = x + dx, Y = y + dy, Z = z + dz, distance = dx * dx + dy * dy + dz * dz;
      const bool isIn = std::min({ X, Y, Z }) >= 0 && std::max({ X, Y, Z }) < n;
      if (distance == 1 && !isIn && hasVoid)
      {
        grains.Add(0, i + 1, 50.0);
      }
      if ((distance == 1 || distance == 3) && isIn && d > 13)
      {
        grains.Add(
          i + 1, numberOf(X, Y, Z), (distance == 1 ? 60.0 : 25.0) * random.Between(0.5, 1.5));
      }
    }
  }
  // Equal pairs, of several sides outside, are one.
  std::map<std::pair<int, int>, ExactSum> sums;
  for (const PairSum& area : grains.Areas)
  {
    sums[{ area.First, area.Second }].Add(area.Value);
  }
  grains.Areas.clear();
  for (const auto& sum : sums)
  {
    grains.Areas.push_back({ sum.first.first, sum.first.second, sum.second });
  }
  grains.DrawLacks(seed + 1);
  grains.Home = [n](int f, int ranks)
  {
    int sides[3] = { 1, 1, 1 }; // of the grid of ranks
    for (int axis = 0, rest = ranks; rest > 1; ++axis)
    {
      const int factor = rest % 3 == 0 ? 3 : rest % 2 == 0 ? 2 : rest;
      sides[axis % 3] *= factor;
      rest /= factor;
    }
    const int x = (f - 1) % n, y = (f - 1) / n % n, z = (f - 1) / (n * n);
    return (z * sides[2] / n * sides[1] + y * sides[1] / n) * sides[0] + x * sides[0] / n;
  };
  return grains;
}

FragmentShare ShareOf(const Grains& grains, Ranks& ranks)
{
  std::vector<std::set<int>> ranksOf(grains.Count + 1);
  for (int f = 1; f <= grains.Count; ++f)
  {
    ranksOf[f].insert(grains.Home(f, ranks.Count()));
  }
  for (const PairSum& area : grains.Areas)
  {
    if (area.First > 0)
    {
      ranksOf[area.First].insert(grains.Home(area.Second, ranks.Count()));
      ranksOf[area.Second].insert(grains.Home(area.First, ranks.Count()));
    }
  }
  FragmentShare share;
  share.Group = &ranks;
  share.Total = grains.Count;
  std::vector<Index> keys;
  for (int f = 1; f <= grains.Count; ++f)
  {
    if (ranksOf[f].count(ranks.Rank()) == 0)
    {
      continue;
    }
    if (ranksOf[f].size() > 1)
    {
      share.Shared.push_back(static_cast<int>(share.Size()));
      keys.push_back(f);
    }
    share.Ids.push_back(f);
    share.Materials.push_back(1);
    share.IsMine.push_back(grains.Home(f, ranks.Count()) == ranks.Rank());
    share.IsShared.push_back(ranksOf[f].size() > 1);
  }
  share.Ways = KeyMerge<Index>(std::move(keys), ranks);
  return share;
}

PairSumMap AreasOf(const Grains& grains, const FragmentShare& share)
{
  PairSumMap areas;
  const int rank = share.Group->Rank(), count = share.Group->Count();
  for (const PairSum& area : grains.Areas)
  {
    for (int f : { area.First > 0 ? area.First : area.Second, area.Second })
    {
      if (grains.Home(f, count) == rank)
      {
        areas[{ share.Find(area.First), share.Find(area.Second) }].Add(0.5 * area.Value.Value());
      }
    }
  }
  return areas;
}

GrainLevel MakeGrainLevel(const Grains& grains, Ranks& ranks)
{
  GrainLevel made;
  made.Level.Share = ShareOf(grains, ranks);
  std::vector<FragmentPair> pairs;
  std::vector<ExactSum> sums;
  for (const auto& sum : AreasOf(grains, made.Level.Share))
  {
    pairs.push_back({ { sum.first.first, sum.first.second } });
    sums.push_back(sum.second);
  }
  made.Level.Pairs = PairShare(made.Level.Share, std::move(pairs));
  made.Level.Pairs.Sum(sums);
  made.Areas = ValuesOf(sums);
  made.Level.Regular.assign(made.Level.Share.Size(), RegularDiagonal);
  made.Lack.assign(1, 0.0);
  for (std::size_t f = 1; f < made.Level.Share.Size(); ++f)
  {
    made.Lack.push_back(grains.Lack[made.Level.Share.Ids[f]]);
  }
  return made;
}

std::vector<double> GatherValues(const FragmentShare& share, const std::vector<double>& values)
{
  EXPECT_EQ(values.size(), share.Size());
  std::vector<double> all(share.Total + 1, -HUGE_VAL);
  for (std::size_t f = 1; f < share.Size(); ++f)
  {
    all[share.Ids[f]] = values[f];
  }
  const std::vector<double> own = all;
  share.Group->Max(all);
  for (std::size_t f = 1; f < share.Size(); ++f)
  {
    EXPECT_EQ(all[share.Ids[f]], own[share.Ids[f]]) << "shared grains are equal";
  }
  all[0] = 0.0;
  return all;
}

std::vector<double> SolveOnRanks(const Grains& grains, int count, const IslandBounds& bounds)
{
  std::vector<double> all(grains.Count + 1, 0.0);
  RunOnRanks(count,
    [&](Ranks& ranks)
    {
      const FragmentShare share = ShareOf(grains, ranks);
      const PairSumMap mine = AreasOf(grains, share);
      const IslandSystem system(share, mine, bounds);
      std::vector<double> lack(1, 0.0);
      for (std::size_t f = 1; f < share.Size(); ++f)
      {
        lack.push_back(grains.Lack[share.Ids[f]]);
      }
      std::vector<ExactSum> none(share.Size());
      const std::vector<double> mu = system.Solve(system.SumAreas(mine, none), lack);
      EXPECT_EQ(mu.size(), share.Size());
      const std::vector<double> ofAll = GatherValues(share, mu);
      if (ranks.Rank() == 0)
      {
        all = ofAll;
      }
    });
  return all;
}

double LargestResidual(const Grains& grains, const std::vector<double>& mu)
{
  std::vector<double> rest = grains.Lack;
  for (const PairSum& area : grains.Areas)
  {
    const double flow = area.Value.Value() * (mu[area.First] - mu[area.Second]);
    rest[area.First] -= flow;
    rest[area.Second] += flow;
  }
  double largest = 0.0;
  for (int f = 1; f <= grains.Count; ++f)
  {
    largest = std::max(largest, std::fabs(rest[f] - RegularDiagonal * mu[f]));
  }
  return largest;
}

} // namespace testing
} // namespace vfm
