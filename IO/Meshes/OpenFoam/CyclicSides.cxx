#include "Meshes/OpenFoam/CyclicSides.h"

#include "Meshes/OpenFoam/CellSides.h"
#include "Ranks/Agreement.h"
#include "Ranks/MergeByKey.h"
#include "Ranks/NumberKeys.h"
#include "Report/DomainSides.h"
#include "Report/MatchFaces.h"
#include "Report/Sets/PeriodicPairs.h"

#include <algorithm>
#include <limits>
#include <tuple>

namespace vfm
{
namespace
{

/// A side of a cell of a rank without a cell behind.
struct OpenSide
{
  int Rank;
  Index Side;
  Vector3 First; // position of its first point, which has the lowest partner, in image axes
  bool operator<(const OpenSide& other) const
  {
    return std::tie(this->Rank, this->Side) < std::tie(other.Rank, other.Side);
  }
};

constexpr OpenSide NoCopy{ std::numeric_limits<int>::max(), 0, {} };

/// The sides whose points have the same partners, ascending, with NoCopy last.
using Copies = std::array<OpenSide, 2>;

Copies JoinCopies(const Copies& a, const Copies& b)
{
  std::array<OpenSide, 4> all{ { a[0], a[1], b[0], b[1] } };
  std::sort(all.begin(), all.end());
  return { { all[0], all[1] } };
}

/// Open sides of this rank with their copies.
struct CopyList
{
  std::vector<FaceIds> Partners; // of the points of each side, ascending
  std::vector<Copies> Sides;
};

/// @pre Collective
CopyList FindCopies(const MeshData& mesh, const std::vector<Index>& open, Ranks& ranks)
{
  CopyList list;
  const ImageFrame frame = FrameOfDomain(mesh);
  for (Index side : open)
  {
    const FaceIds points = PointsOfSide(mesh, side);
    list.Partners.push_back(SortedIds(points, mesh.PeriodicPartner));
    list.Sides.push_back(
      { { { ranks.Rank(), side, frame.ToOwn(mesh.PointAt(points[0])) }, NoCopy } });
  }
  list.Sides = MergeByKey(list.Partners, list.Sides, JoinCopies, ranks);
  return list;
}

/// Returns the name of the patch on the side of the domain in a direction.
std::string NameOfPatch(const Index3& direction)
{
  std::string name;
  for (int a = 0; a < 3; ++a)
  {
    if (direction[a] != 0)
    {
      name += (name.empty() ? "" : "_") + std::string(1, "xyz"[a]);
      name += direction[a] < 0 ? "_min" : "_max";
    }
  }
  return name;
}

Index3 Opposite(const Index3& periods)
{
  return { { -periods[0], -periods[1], -periods[2] } };
}

/// Returns the periods from the first to the second copy. Swaps them so that the periods are
/// greater than the opposite ones.
Index3 OrientCopies(const std::vector<double>& lengths, Copies& pair)
{
  const Index3 count = CountPeriods(pair[0].First, pair[1].First, lengths);
  if (!(count < Opposite(count)))
  {
    return count;
  }
  std::swap(pair[0], pair[1]);
  return Opposite(count);
}

/// A pair of sides of which one at least is on this rank.
struct CyclicPair
{
  FaceIds Partners;
  Index3 Periods;
  Copies Sides;
};

/// Returns the position of each pair among those of all ranks, by patch, then by partners.
/// @param patches  of each pair
/// @pre Collective
std::vector<Index> NumberPairs(
  const std::vector<CyclicPair>& pairs, const std::vector<Index>& patches, Ranks& ranks)
{
  std::vector<std::array<Index, 5>> keys;
  Index greatest = 0;
  for (std::size_t p = 0; p < pairs.size(); ++p)
  {
    const FaceIds& ids = pairs[p].Partners;
    keys.push_back({ { patches[p], ids[0], ids[1], ids[2], ids[3] } });
    greatest = std::max(greatest, ids[3]);
  }
  const ValueInGroup value(MaximumOverRanks(greatest, ranks));
  const auto valueOf = [&value](const std::array<Index, 5>& key)
  {
    const auto lowest = std::find_if(key.begin() + 1, key.end(), [](Index id) { return id >= 0; });
    return value(key[0], *lowest);
  };
  return NumberItems(keys, valueOf, ranks).Numbers;
}

/// Collects the patches of pairs.
/// @pre Collective
std::vector<CyclicPatches> MakePatches(const std::vector<CyclicPair>& pairs, Ranks& ranks)
{
  std::vector<Index3> periods;
  for (const CyclicPair& pair : pairs)
  {
    periods.push_back(pair.Periods);
  }
  std::vector<Index3> all = UnionOverRanks(ranks, std::move(periods));
  std::reverse(all.begin(), all.end());
  std::vector<Index> patches;
  std::vector<std::int64_t> counts(
    all.size(), 0); // a pair is counted by the rank of its first side
  for (const CyclicPair& pair : pairs)
  {
    patches.push_back(std::find(all.begin(), all.end(), pair.Periods) - all.begin());
    counts[patches.back()] += pair.Sides[0].Rank == ranks.Rank() ? 1 : 0;
  }
  ranks.Sum(counts);
  const std::vector<Index> numbers = NumberPairs(pairs, patches, ranks);
  std::vector<CyclicPatches> found;
  std::vector<Index> firsts;
  for (std::size_t patch = 0; patch < all.size(); ++patch)
  {
    firsts.push_back(patch == 0 ? 0 : firsts.back() + counts[patch - 1]);
    found.push_back(
      { { { NameOfPatch(Opposite(all[patch])), NameOfPatch(all[patch]) } }, {}, counts[patch] });
  }
  for (std::size_t p = 0; p < pairs.size(); ++p)
  {
    for (int s = 0; s < 2; ++s)
    {
      const OpenSide &side = pairs[p].Sides[s], &copy = pairs[p].Sides[1 - s];
      if (side.Rank == ranks.Rank())
      {
        found[patches[p]].Sides[s].push_back(
          { side.Side, copy.Rank, numbers[p] - firsts[patches[p]] });
      }
    }
  }
  return found;
}

} // namespace

CyclicSides FindCyclicSides(const MeshData& mesh, const std::vector<Index>& open, Ranks& ranks)
{
  CyclicSides found;
  if (!ranks.Any(mesh.PeriodicPartner != nullptr))
  {
    found.Others = open;
    return found;
  }
  const std::vector<double> lengths = NumbersOfField(mesh.Fields, "PeriodLengths");
  if (lengths.size() != 3)
  {
    RejectMissing("PeriodLengths");
  }
  const CopyList copies = FindCopies(mesh, open, ranks);
  std::vector<CyclicPair> pairs;
  for (std::size_t place : OrderOf(copies.Partners))
  {
    Copies pair = copies.Sides[place];
    if (pair[1].Rank == NoCopy.Rank)
    {
      found.Others.push_back(open[place]);
    }
    else if (pairs.empty() || pairs.back().Partners != copies.Partners[place])
    {
      const Index3 periods = OrientCopies(lengths, pair);
      pairs.push_back({ copies.Partners[place], periods, pair });
    }
  }
  found.Patches = MakePatches(pairs, ranks);
  std::sort(found.Others.begin(), found.Others.end());
  return found;
}

} // namespace vfm
