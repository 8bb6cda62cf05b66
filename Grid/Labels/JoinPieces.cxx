#include "Labels/JoinPieces.h"

#include "Base/DisjointSets.h"
#include "Ranks/NumberKeys.h"
#include "Ranks/NumberLimit.h"

#include <limits>

namespace vfm
{
namespace
{

// Rounds in which labels only spread to peers. Most fragments that cross ranks are complete then.
constexpr int PlainRounds = 3;

/// A part of a fragment on any rank, by its lowest cell. The lowest part of a fragment is its root.
struct Label
{
  Index Lowest, Part;
  bool operator<(const Label& other) const
  {
    return this->Lowest != other.Lowest ? this->Lowest < other.Lowest : this->Part < other.Part;
  }
};

constexpr Label Highest{ std::numeric_limits<Index>::max(), std::numeric_limits<Index>::max() };

void TakeLower(Label& a, const Label& b)
{
  a = std::min(a, b);
}

/// Parts of fragments on this rank: components that pairs of this rank join. A part has the number
/// of its lowest component.
class Parts
{
public:
  Parts(const std::vector<Piece>& mine, const PiecePairs& same, const std::vector<int>& peers,
    Ranks& ranks) :
    Group(ranks), Offset(OffsetOfRank(ranks)), PartOf(MakeSets(mine.size())), Peers(peers)
  {
    for (const auto& pair : same)
    {
      if (this->RankOf(pair[1]) == ranks.Rank())
      {
        Join(this->PartOf, pair[0] - this->Offset, pair[1] - this->Offset);
      }
    }
    for (std::size_t p = 0; p < mine.size(); ++p)
    {
      this->PartOf[p] = FindRoot(this->PartOf, static_cast<Index>(p));
      this->Labels.push_back({ mine[p].Lowest, this->Offset + this->PartOf[p] });
      TakeLower(this->Labels[this->PartOf[p]], this->Labels[p]);
    }
    this->IsAtBorder.assign(mine.size(), 0);
    SortUnique(this->Peers);
    this->Peers.erase(
      std::remove(this->Peers.begin(), this->Peers.end(), ranks.Rank()), this->Peers.end());
    this->ListBorders(same);
  }

  /// Lowers the labels of all parts to those of the roots of their fragments: labels spread between
  /// peers, with hooking and shortcuts as in FastSV (Zhang, Azad, Hu 2020) after some rounds.
  void FindRoots(int& rounds, int& shortcuts)
  {
    while (this->Group.Any(this->Spread()))
    {
      if (++rounds >= PlainRounds)
      {
        ++shortcuts;
        this->Shorten();
      }
    }
  }

  const Label& LabelOf(std::size_t piece) const { return this->Labels[this->PartOf[piece]]; }
  bool IsRoot(std::size_t piece) const
  {
    return this->LabelOf(piece).Part == this->Offset + this->PartOf[piece];
  }
  bool IsShared(std::size_t piece) const { return this->IsAtBorder[this->PartOf[piece]] != 0; }

private:
  static int RankOf(Index component) { return static_cast<int>(component >> 32); }

  /// Lists the parts at each peer in an order that both ranks have.
  void ListBorders(const PiecePairs& same)
  {
    std::vector<PiecePairs> pairs(this->Peers.size());
    for (const auto& pair : same)
    {
      if (this->RankOf(pair[1]) != this->Group.Rank())
      {
        pairs[FindSorted(this->Peers, this->RankOf(pair[1]))].push_back(pair);
      }
    }
    const std::vector<Bytes> theirs = this->Group.Exchange(this->Peers, PackLists(pairs));
    for (std::size_t p = 0; p < pairs.size(); ++p)
    {
      for (const auto& pair : FromBytes<std::array<Index, 2>>(theirs[p]))
      {
        pairs[p].push_back({ { pair[1], pair[0] } });
      }
      const int low = this->Group.Rank() < this->Peers[p] ? 0 : 1; // that of the lower rank
      std::sort(pairs[p].begin(), pairs[p].end(),
        [low](const auto& a, const auto& b)
        { return std::pair(a[low], a[1 - low]) < std::pair(b[low], b[1 - low]); });
      pairs[p].erase(std::unique(pairs[p].begin(), pairs[p].end()), pairs[p].end());
      this->Borders.emplace_back();
      for (const auto& pair : pairs[p])
      {
        const Index part = this->PartOf[pair[0] - this->Offset];
        this->Borders.back().push_back(part);
        this->IsAtBorder[part] = 1;
      }
    }
    for (std::size_t p = 0; p < this->PartOf.size(); ++p)
    {
      if (this->PartOf[p] == static_cast<Index>(p) && this->IsAtBorder[p])
      {
        this->BorderParts.push_back(static_cast<Index>(p));
      }
    }
  }

  /// Sends labels to the peers. Returns whether any became lower here.
  bool Spread()
  {
    this->Before = this->Labels;
    std::vector<std::vector<Label>> sent(this->Borders.size());
    for (std::size_t p = 0; p < sent.size(); ++p)
    {
      for (Index part : this->Borders[p])
      {
        sent[p].push_back(this->Labels[part]);
      }
    }
    const std::vector<Bytes> received = this->Group.Exchange(this->Peers, PackLists(sent));
    bool isLower = false;
    for (std::size_t p = 0; p < received.size(); ++p)
    {
      const std::vector<Label> labels = FromBytes<Label>(received[p]);
      for (std::size_t i = 0; i < labels.size(); ++i)
      {
        Label& own = this->Labels[this->Borders[p][i]];
        isLower = isLower || labels[i] < own;
        TakeLower(own, labels[i]);
      }
    }
    return isLower;
  }

  /// Each part tells the part of its label before Spread its new one, and takes the labels that the
  /// parts of both labels have.
  void Shorten()
  {
    std::vector<Index> keys;
    for (Index part : this->BorderParts)
    {
      keys.insert(
        keys.end(), { this->Offset + part, this->Before[part].Part, this->Labels[part].Part });
    }
    SortUnique(keys);
    std::vector<Label> values(keys.size(), Highest);
    const auto valueOf = [&](Index part) -> Label& { return values[FindSorted(keys, part)]; };
    for (Index part : this->BorderParts)
    {
      TakeLower(valueOf(this->Offset + part), this->Labels[part]);
      TakeLower(valueOf(this->Before[part].Part), this->Labels[part]);
    }
    KeyMerge<Index>(keys, this->Group).Merge(values, 1, TakeLower);
    for (Index part : this->BorderParts)
    {
      const Index target = this->Labels[part].Part;
      for (Index other : { this->Offset + part, this->Before[part].Part, target })
      {
        TakeLower(this->Labels[part], valueOf(other));
      }
    }
  }

  Ranks& Group;
  const Index Offset;
  std::vector<Index> PartOf;             // of each component
  std::vector<Label> Labels;             // lowest known label of each part
  std::vector<Label> Before;             // Labels before Spread
  std::vector<unsigned char> IsAtBorder; // whether parts of other ranks belong to the fragment
  std::vector<Index> BorderParts;        // ascending
  std::vector<int> Peers;
  std::vector<std::vector<Index>> Borders; // parts at each peer
};

/// Returns the lowest cells of the fragments of this rank, ascending.
std::vector<Index> ListLowest(const Parts& parts, std::size_t pieces)
{
  std::vector<Index> lowest;
  for (std::size_t p = 0; p < pieces; ++p)
  {
    lowest.push_back(parts.LabelOf(p).Lowest);
  }
  SortUnique(lowest);
  return lowest;
}

/// Returns the fragments of this rank, without materials and owners.
/// @param lowest  lowest cells of the fragments
FragmentShare NumberThem(const std::vector<Index>& lowest, Ranks& ranks)
{
  const KeyNumbers numbers = NumberKeys(
    lowest, [](Index key) { return key; }, ranks);
  CheckNumberLimit(numbers.Total, "fragments");
  FragmentShare share;
  share.Group = &ranks;
  share.Total = numbers.Total;
  for (std::int64_t number : numbers.Numbers)
  {
    share.Ids.push_back(static_cast<int>(number) + 1);
  }
  share.Materials.resize(share.Size(), 0);
  share.IsMine.resize(share.Size(), 0);
  share.IsShared.resize(share.Size(), 0);
  return share;
}

/// Finds the ways of the shared fragments.
void FindWays(FragmentShare& share)
{
  std::vector<Index> keys;
  for (std::size_t f = 1; f < share.Size(); ++f)
  {
    if (share.IsShared[f])
    {
      share.Shared.push_back(static_cast<int>(f));
      keys.push_back(share.Ids[f]);
    }
  }
  share.Ways = KeyMerge<Index>(std::move(keys), *share.Group);
}

} // namespace

JoinedPieces JoinPieces(const std::vector<Piece>& mine, const PiecePairs& same,
  const std::vector<int>& peers, Ranks& ranks)
{
  JoinedPieces joined;
  Parts parts(mine, same, peers, ranks);
  parts.FindRoots(joined.Rounds, joined.Shortcuts);
  const std::vector<Index> lowest = ListLowest(parts, mine.size());
  FragmentShare& share = joined.Share;
  share = NumberThem(lowest, ranks);
  for (std::size_t p = 0; p < mine.size(); ++p)
  {
    const int f = static_cast<int>(FindSorted(lowest, parts.LabelOf(p).Lowest)) + 1;
    joined.Fragments.push_back(f);
    share.Materials[f] = static_cast<int>(mine[p].Label);
    share.IsMine[f] |= parts.IsRoot(p);
    share.IsShared[f] |= parts.IsShared(p);
  }
  FindWays(share);
  return joined;
}

} // namespace vfm
