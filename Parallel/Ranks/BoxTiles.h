/**
 * BoxTiles: tiles of space where ranks meet whose boxes are near each other.
 *
 * Space is divided into tiles of the size of most boxes, on several levels: a tile of a level is
 * eight tiles of the level below. A box belongs to the lowest level whose tiles are at least as
 * large as the box, so it meets at most eight of them. Two boxes with common cells meet a common
 * tile of the higher one of their levels.
 */
#pragma once

#include "Ranks/Ranks.h"

#include <algorithm>
#include <array>

namespace vfm
{

/// Tiles for the boxes of all ranks. Equal on all ranks.
class BoxTiles
{
public:
  using Position = std::array<std::int64_t, 3>; ///< i, j, k of a cell, or numbers of cells
  using Tile = std::array<std::int64_t, 4>;     ///< level and position

  /// @param sizes  sizes of the boxes of this rank
  /// @pre Collective over `ranks`.  @note One sum of 768 bytes.
  BoxTiles(const std::vector<Position>& sizes, Ranks& ranks);

  /// Returns the level of a box; 0 is the lowest one.
  int LevelOf(const Position& size) const;
  /// Returns the tile of a level that contains a cell.
  Tile TileOf(int level, const Position& cell) const
  {
    return { { level, cell[0] >> this->ShiftOf(level, 0), cell[1] >> this->ShiftOf(level, 1),
      cell[2] >> this->ShiftOf(level, 2) } };
  }
  /// Calls visit(tile) for the tiles that meet a box, of all levels from `level` on to which some
  /// box of any rank belongs.
  /// @param box  with Lower and Upper as IndexBox; has cells
  template <class Box, class Visit>
  void ForTiles(int level, const Box& box, const Visit& visit) const;

private:
  static constexpr int Exponents = 32; // of sizes; larger boxes count as the last one
  static int ExponentOf(std::int64_t size);
  int ShiftOf(int level, int axis) const { return std::min(this->Lowest[axis] + level, 62); }

  std::array<int, 3> Lowest; // tiles of level 0 have 2^Lowest cells along each axis
  std::array<bool, Exponents> IsUsed{};
};

/// Returns the numbers of cells of a box along the axes.
template <class Box>
BoxTiles::Position SizeOf(const Box& box)
{
  return { { box.Upper[0] - box.Lower[0], box.Upper[1] - box.Lower[1],
    box.Upper[2] - box.Lower[2] } };
}

/// Returns the cells of a domain of which a box holds copies, as boxes, which may overlap; none for
/// a box without cells.
/// @param repeats  whether the domain repeats along each axis; along others the box is inside
template <class Box>
std::vector<Box> FoldIntoDomain(
  const Box& box, const Box& domain, const std::array<bool, 3>& repeats)
{
  const BoxTiles::Position size = SizeOf(box), periods = SizeOf(domain);
  std::vector<Box> parts;
  if (size[0] > 0 && size[1] > 0 && size[2] > 0)
  {
    parts.push_back(box);
  }
  for (int a = 0; a < 3; ++a)
  {
    for (std::size_t p = 0, count = parts.size(); repeats[a] && p < count; ++p)
    {
      const std::int64_t first = domain.Lower[a], width = std::min(size[a], periods[a]);
      const std::int64_t offset = (box.Lower[a] - first) % periods[a];
      Box& part = parts[p];
      part.Lower[a] = first + offset + (offset < 0 ? periods[a] : 0);
      part.Upper[a] = part.Lower[a] + width;
      if (part.Upper[a] > domain.Upper[a]) // the rest begins at the other side
      {
        Box rest = part;
        rest.Lower[a] = first;
        rest.Upper[a] = part.Upper[a] - periods[a];
        part.Upper[a] = domain.Upper[a];
        parts.push_back(rest);
      }
    }
  }
  return parts;
}

template <class Box, class Visit>
void BoxTiles::ForTiles(int level, const Box& box, const Visit& visit) const
{
  const Position last{ { box.Upper[0] - 1, box.Upper[1] - 1, box.Upper[2] - 1 } };
  for (; level < Exponents; ++level)
  {
    if (!this->IsUsed[level])
    {
      continue;
    }
    const Tile first = this->TileOf(level, box.Lower), end = this->TileOf(level, last);
    Tile tile{ { level, 0, 0, 0 } };
    for (tile[3] = first[3]; tile[3] <= end[3]; ++tile[3])
    {
      for (tile[2] = first[2]; tile[2] <= end[2]; ++tile[2])
      {
        for (tile[1] = first[1]; tile[1] <= end[1]; ++tile[1])
        {
          visit(static_cast<const Tile&>(tile));
        }
      }
    }
  }
}

} // namespace vfm
