#include "HiddenCells.h"

namespace vfm
{
namespace
{

/// Returns the marks that the simulation has for a box, or null.
const unsigned char* FindGhostTypes(const HostBox& box)
{
  for (const HostArray& array : box.Arrays)
  {
    if (array.Name == GhostTypeName && array.Type == HostType::UnsignedChar &&
      array.Components == 1)
    {
      return static_cast<const unsigned char*>(array.Values);
    }
  }
  return nullptr;
}

/// Returns the cells of a box without layers that are copies of other boxes. Coarser cells below
/// such layers may be the finest at their place.
HostPlace FindPlace(const HostBox& box)
{
  const unsigned char* types = FindGhostTypes(box);
  HostPlace place{ box.Cells, box.Level };
  if (types)
  {
    place.Cells = { box.Cells.Upper, box.Cells.Lower };
    ForCells(box.Cells,
      [&](const Index3& cell)
      {
        if (*types++ & DuplicateCell)
        {
          return;
        }
        for (int a = 0; a < 3; ++a)
        {
          place.Cells.Lower[a] = std::min(place.Cells.Lower[a], cell[a]);
          place.Cells.Upper[a] = std::max(place.Cells.Upper[a], cell[a] + 1);
        }
      });
  }
  return place;
}

/// Returns the marks of the simulation, or zeros.
std::vector<unsigned char> CopyGhostTypes(const HostBox& box)
{
  const Index cells = box.Cells.NumberOfCells();
  const unsigned char* types = FindGhostTypes(box);
  return types ? std::vector<unsigned char>(types, types + cells)
               : std::vector<unsigned char>(cells, 0);
}

} // namespace

HostPlaces GatherHostPlaces(const HostGrid& grid, Ranks& ranks)
{
  std::vector<HostPlace> mine;
  for (const HostBox& box : grid.Boxes)
  {
    mine.push_back(FindPlace(box));
  }
  HostPlaces places;
  const std::vector<Bytes> gathered = ranks.Gather(ToBytes(mine));
  for (int rank = 0; rank < ranks.Count(); ++rank)
  {
    const std::vector<HostPlace> boxes = FromBytes<HostPlace>(gathered[rank]);
    places.First += rank < ranks.Rank() ? boxes.size() : 0;
    places.Most = std::max(places.Most, boxes.size());
    places.All.insert(places.All.end(), boxes.begin(), boxes.end());
  }
  return places;
}

std::vector<unsigned char> HideCovered(const HostBox& box, const HostPlaces& places)
{
  std::vector<unsigned char> types;
  for (const HostPlace& place : places.All)
  {
    const int finer = static_cast<int>(place.Level) - box.Level;
    const IndexBox covered =
      finer > 0 ? Intersect(ChangeLevel(place.Cells, -finer), box.Cells) : IndexBox();
    if (covered.NumberOfCells() > 0)
    {
      types = types.empty() ? CopyGhostTypes(box) : std::move(types);
      ForCells(
        covered, [&](const Index3& cell) { types[IndexInBox(box.Cells, cell)] |= HiddenCell; });
    }
  }
  return types;
}

} // namespace vfm
