#include "Volumes/FindIslands.h"

#include "Base/DisjointSets.h"

#include <limits>

namespace vfm
{
namespace
{

// Rounds in which labels only spread to the ranks that share a fragment. Most islands are complete
// then.
constexpr int PlainRounds = 2;

void TakeLower(Index& a, Index b)
{
  a = std::min(a, b);
}

/// Sets of connected fragments of a rank, and the lowest fragment of all ranks that is known to be
/// connected with each: its label. A set has the number of its lowest fragment over all ranks as
/// its name; sets of the same name are connected. Labels fall from round to round as in FastSV
/// (Zhang, Azad, Hu 2020): a set passes its label on to the set that its last label names
/// (hooking), and takes the labels of the sets that its labels name (shortcut).
class ConnectedSets
{
public:
  ConnectedSets(const FragmentShare& share, const std::vector<FragmentPair>& pairs) :
    Share(share), SetOf(MakeSets(share.Size())), IsShared(share.Size(), 0)
  {
    for (const auto& [a, b] : pairs)
    {
      if (a > 0)
      {
        Join(this->SetOf, a, b);
      }
    }
    for (std::size_t f = 0; f < share.Size(); ++f)
    {
      this->SetOf[f] = FindRoot(this->SetOf, static_cast<Index>(f));
    }
    for (int f : share.Shared)
    {
      if (!this->IsShared[this->SetOf[f]])
      {
        this->IsShared[this->SetOf[f]] = 1;
        this->SharedSets.push_back(static_cast<int>(this->SetOf[f]));
      }
    }
    this->Labels.assign(share.Ids.begin(), share.Ids.end());
  }

  int Connect()
  {
    int rounds = 0;
    for (; this->Share.Group->Any(this->Spread()); ++rounds)
    {
      if (rounds >= PlainRounds)
      {
        this->Shorten();
      }
    }
    return rounds;
  }

  const FragmentShare& Share;
  std::vector<Index> SetOf;            // set of each fragment: its lowest fragment on this rank
  std::vector<unsigned char> IsShared; // whether other ranks have a fragment of each set
  std::vector<int> SharedSets;
  std::vector<Index> Labels; // of each set

private:
  /// Spreads labels between the ranks that share a fragment. Returns whether any fell.
  bool Spread()
  {
    this->Before = this->Labels;
    std::vector<Index> labels(this->Labels.size(), 0);
    for (int f : this->Share.Shared)
    {
      labels[f] = this->Labels[this->SetOf[f]];
    }
    this->Share.Merge(labels, 1, TakeLower);
    bool isNew = false;
    for (int f : this->Share.Shared)
    {
      isNew = isNew || labels[f] < this->Labels[this->SetOf[f]];
      TakeLower(this->Labels[this->SetOf[f]], labels[f]);
    }
    return isNew;
  }

  void Shorten()
  {
    std::vector<Index> keys;
    for (int set : this->SharedSets)
    {
      keys.insert(keys.end(), { this->Share.Ids[set], this->Before[set], this->Labels[set] });
    }
    SortUnique(keys);
    std::vector<Index> values(keys.size(), std::numeric_limits<Index>::max());
    const auto valueOf = [&](Index name) -> Index& { return values[FindSorted(keys, name)]; };
    for (int set : this->SharedSets)
    {
      TakeLower(valueOf(this->Share.Ids[set]), this->Labels[set]);
      TakeLower(valueOf(this->Before[set]), this->Labels[set]);
    }
    KeyMerge<Index>(keys, *this->Share.Group).Merge(values, 1, TakeLower);
    for (int set : this->SharedSets)
    {
      Index& label = this->Labels[set];
      const Index below = valueOf(label);
      TakeLower(label, valueOf(this->Share.Ids[set]));
      TakeLower(label, valueOf(this->Before[set]));
      TakeLower(label, below);
    }
  }

  std::vector<Index> Before;
};

} // namespace

Islands FindIslands(const FragmentShare& share, const std::vector<FragmentPair>& pairs)
{
  ConnectedSets sets(share, pairs);
  Islands islands;
  islands.Rounds = share.Group->Count() > 1 ? sets.Connect() : 0;
  std::vector<Index> sizes(share.Size(), 0), keys; // sizes by set
  for (std::size_t f = 1; f < share.Size(); ++f)
  {
    sizes[sets.SetOf[f]] += share.IsMine[f];
  }
  for (int set : sets.SharedSets)
  {
    keys.push_back(sets.Labels[set]);
  }
  SortUnique(keys);
  std::vector<Index> counts(keys.size(), 0);
  for (int set : sets.SharedSets)
  {
    counts[FindSorted(keys, sets.Labels[set])] += sizes[set];
  }
  KeyMerge<Index>(keys, *share.Group).Merge(counts, 1, [](Index& a, Index b) { a += b; });
  for (int set : sets.SharedSets)
  {
    sizes[set] = counts[FindSorted(keys, sets.Labels[set])];
  }
  for (std::size_t f = 0; f < share.Size(); ++f)
  {
    const Index set = sets.SetOf[f];
    islands.Lowest.push_back(static_cast<int>(sets.Labels[set]));
    islands.Sizes.push_back(sizes[set]);
    islands.AreShared.push_back(sets.IsShared[set]);
  }
  return islands;
}

} // namespace vfm
