/**
 * FindMeetings: finds which boxes of different ranks meet, without a list of the boxes of all ranks
 * on any rank.
 *
 * Each box is registered at the homes of the tiles that it meets (BoxTiles.h); homes are ranks from
 * a hash of the tile. A home compares the boxes of each of its tiles, and sends each of two that
 * meet to the rank of the other one.
 */
#pragma once

#include "Ranks/BoxTiles.h"
#include "Ranks/ItemRoute.h"
#include "Ranks/MeetingRank.h"

#include <set>
#include <tuple>
#include <utility>

namespace vfm
{

/// An item of any rank.
template <class Item>
struct RankItem
{
  Item What;
  int Rank;   ///< rank that has it
  int Number; ///< position in the list of that rank
};

/// The items whose tiles have this rank as their home.
template <class Item, class BoxesOf>
class TileMeetings
{
public:
  /// Sends the items of all ranks to the homes of their tiles.
  /// @pre Collective over `ranks`.
  TileMeetings(
    const std::vector<Item>& own, const BoxTiles& tiles, const BoxesOf& boxesOf, Ranks& ranks);

  /// Returns the items of other ranks that meet an item of this rank.
  /// @pre Collective.
  template <class Meet>
  std::vector<RankItem<Item>> Answer(const Meet& meet);

private:
  using Boxes = decltype(std::declval<BoxesOf>()(std::declval<Item>()));
  using Tile = BoxTiles::Tile;

  int HomeOf(const Tile& tile) const { return MeetingRank(tile, this->Group.Count()); }
  template <class Visit>
  void ForTiles(const Boxes& boxes, const Visit& visit) const;
  void Add(const RankItem<Item>& item);
  template <class Visit>
  void ForPairs(const Visit& visit) const;
  Tile CommonTile(int a, int b, int level) const;

  const BoxTiles& Tiles;
  const BoxesOf& TheBoxesOf;
  Ranks& Group;
  std::vector<RankItem<Item>> Items;
  std::vector<Boxes> ItemBoxes;
  /// Tile, whether the item is not registered there, item; ascending, each once.
  std::vector<std::tuple<Tile, bool, int>> Visits;
};

template <class Item, class BoxesOf>
TileMeetings<Item, BoxesOf>::TileMeetings(
  const std::vector<Item>& own, const BoxTiles& tiles, const BoxesOf& boxesOf, Ranks& ranks) :
  Tiles(tiles), TheBoxesOf(boxesOf), Group(ranks)
{
  std::vector<RankItem<Item>> sent;
  std::vector<int> to;
  for (std::size_t i = 0; i < own.size(); ++i)
  {
    std::set<int> homes;
    this->ForTiles(
      boxesOf(own[i]), [&](const Tile& tile, bool) { homes.insert(this->HomeOf(tile)); });
    sent.resize(sent.size() + homes.size(), { own[i], ranks.Rank(), static_cast<int>(i) });
    to.insert(to.end(), homes.begin(), homes.end());
  }
  for (const RankItem<Item>& item : ItemRoute(to, ranks).Send(sent))
  {
    this->Add(item);
  }
  std::sort(this->Visits.begin(), this->Visits.end());
  this->Visits.erase(std::unique(this->Visits.begin(), this->Visits.end()), this->Visits.end());
}

template <class Item, class BoxesOf>
template <class Meet>
std::vector<RankItem<Item>> TileMeetings<Item, BoxesOf>::Answer(const Meet& meet)
{
  std::set<std::pair<int, int>> answers; // rank and item
  this->ForPairs(
    [&](int a, int b)
    {
      if (meet(this->Items[a].What, this->Items[b].What))
      {
        answers.insert({ this->Items[a].Rank, b });
        answers.insert({ this->Items[b].Rank, a });
      }
    });
  std::vector<int> to;
  std::vector<RankItem<Item>> sent;
  for (const auto& answer : answers)
  {
    to.push_back(answer.first);
    sent.push_back(this->Items[answer.second]);
  }
  return ItemRoute(to, this->Group).Send(sent);
}

/// Calls visit(tile, isRegistered) for the tiles of an item: of its level, where it is registered,
/// and of higher ones.
template <class Item, class BoxesOf>
template <class Visit>
void TileMeetings<Item, BoxesOf>::ForTiles(const Boxes& boxes, const Visit& visit) const
{
  int level = 0;
  for (const auto& box : boxes)
  {
    level = std::max(level, this->Tiles.LevelOf(SizeOf(box)));
  }
  for (const auto& box : boxes)
  {
    this->Tiles.ForTiles(level, box, [&](const Tile& tile) { visit(tile, tile[0] == level); });
  }
}

template <class Item, class BoxesOf>
void TileMeetings<Item, BoxesOf>::Add(const RankItem<Item>& item)
{
  const int number = static_cast<int>(this->Items.size());
  this->Items.push_back(item);
  this->ItemBoxes.push_back(this->TheBoxesOf(item.What));
  this->ForTiles(this->ItemBoxes.back(),
    [&](const Tile& tile, bool isRegistered)
    {
      if (this->HomeOf(tile) == this->Group.Rank())
      {
        this->Visits.push_back({ tile, !isRegistered, number });
      }
    });
}

/// Calls visit(a, b) for pairs of items of different ranks whose boxes have a common cell. Each
/// pair is visited on one home, once.
template <class Item, class BoxesOf>
template <class Visit>
void TileMeetings<Item, BoxesOf>::ForPairs(const Visit& visit) const
{
  for (auto first = this->Visits.begin(); first != this->Visits.end(); ++first)
  {
    const auto& [tile, onlyAsks, a] = *first;
    for (auto second = first + 1;
         !onlyAsks && second != this->Visits.end() && std::get<0>(*second) == tile; ++second)
    {
      const int b = std::get<2>(*second);
      if (this->Items[a].Rank != this->Items[b].Rank &&
        this->CommonTile(a, b, static_cast<int>(tile[0])) == tile)
      {
        visit(a, b);
      }
    }
  }
}

/// Returns the tile of the lowest common cell of two items; no tile if they have none.
template <class Item, class BoxesOf>
BoxTiles::Tile TileMeetings<Item, BoxesOf>::CommonTile(int a, int b, int level) const
{
  const int first = this->Items[a].Rank < this->Items[b].Rank ? a : b;
  for (const auto& one : this->ItemBoxes[first])
  {
    for (const auto& other : this->ItemBoxes[a + b - first])
    {
      BoxTiles::Position lower;
      bool isCommon = true;
      for (int axis = 0; axis < 3; ++axis)
      {
        lower[axis] = std::max(one.Lower[axis], other.Lower[axis]);
        isCommon = isCommon && lower[axis] < std::min(one.Upper[axis], other.Upper[axis]);
      }
      if (isCommon)
      {
        return this->Tiles.TileOf(level, lower);
      }
    }
  }
  return { { -1, 0, 0, 0 } };
}

/// Returns the items of other ranks that meet an item of this rank, ordered by rank, then as in
/// the list of that rank.
/// @tparam Item  trivially copyable type
/// @param own  items of this rank
/// @param boxesOf  boxesOf(item) returns a list of boxes with Lower and Upper as IndexBox, each
///   with cells; the same on all ranks
/// @param meet  meet(a, b) returns whether two items of different ranks meet, in any order, the
///   same on all ranks; called only for items whose boxes have a common cell
/// @pre Collective over `ranks`.
/// @note Two ways of about log2 P messages, and one sum. For a while a rank holds the items that
///   meet its tiles.
template <class Item, class BoxesOf, class Meet>
std::vector<RankItem<Item>> FindMeetings(
  const std::vector<Item>& own, const BoxesOf& boxesOf, const Meet& meet, Ranks& ranks)
{
  if (ranks.Count() == 1)
  {
    return {};
  }
  std::vector<BoxTiles::Position> sizes;
  for (const Item& item : own)
  {
    for (const auto& box : boxesOf(item))
    {
      sizes.push_back(SizeOf(box));
    }
  }
  const BoxTiles tiles(sizes, ranks);
  auto found = TileMeetings<Item, BoxesOf>(own, tiles, boxesOf, ranks).Answer(meet);
  const auto place = [](const RankItem<Item>& item)
  { return std::make_pair(item.Rank, item.Number); };
  std::sort(found.begin(), found.end(),
    [&](const RankItem<Item>& a, const RankItem<Item>& b) { return place(a) < place(b); });
  found.erase(
    std::unique(found.begin(), found.end(),
      [&](const RankItem<Item>& a, const RankItem<Item>& b) { return place(a) == place(b); }),
    found.end());
  return found;
}

} // namespace vfm
