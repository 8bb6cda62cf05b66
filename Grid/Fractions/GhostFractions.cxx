#include "Fractions/GhostFractions.h"

namespace vfm
{
namespace
{

using Part = FractionField::Part;

/// Packs a box: the number of bytes of the entries; an entry per cell, its label or ~(number of
/// parts); the parts.
Bytes PackBox(const FractionField& fractions, const Partition& partition, const IndexBox& box)
{
  RunCoder<int> entries;
  std::vector<Part> parts;
  const auto add = [&](Index cell)
  {
    if (!fractions.IsMixed(cell))
    {
      entries.Add(fractions.Label(cell));
      return;
    }
    const FractionField::Range own = fractions.Parts(cell);
    entries.Add(~static_cast<int>(own.end() - own.begin()));
    parts.insert(parts.end(), own.begin(), own.end());
  };
  partition.ForRows(box,
    [&](Index first, Index last)
    {
      fractions.Visit(
        first, last, [&](Index begin, Index end, int label) { entries.AddRun(label, end - begin); },
        [&](Index begin, Index end)
        {
          for (Index cell = begin; cell < end; ++cell)
          {
            add(cell);
          }
        });
    });
  const Bytes coded = ToBytes(entries.Coded());
  const Bytes rest = ToBytes(parts);
  Bytes bytes = ToBytes(std::vector<Index>{ static_cast<Index>(coded.size()) });
  bytes.reserve(bytes.size() + coded.size() + rest.size());
  bytes.insert(bytes.end(), coded.begin(), coded.end());
  bytes.insert(bytes.end(), rest.begin(), rest.end());
  return bytes;
}

void UnpackBox(
  const Bytes& bytes, const Partition& partition, const IndexBox& box, FractionField& fractions)
{
  const auto first = bytes.begin() + sizeof(Index);
  const auto middle = first + FromBytes<Index>(Bytes(bytes.begin(), first))[0];
  RunReader<int> entries(FromBytes<int>(Bytes(first, middle)));
  const std::vector<Part> parts = FromBytes<Part>(Bytes(middle, bytes.end()));
  const Part* part = parts.data();
  FractionField::RowWriter row(fractions);
  const auto add = [&](int entry)
  {
    if (entry >= 0)
    {
      row.AddLabel(entry);
      return;
    }
    row.CopyParts({ part, part + ~entry });
    part += ~entry;
  };
  partition.ForRows(box,
    [&](Index begin, Index end)
    {
      row.Start(begin);
      entries.Read(
        end - begin, [&](Index count, int label) { row.AddLabel(label, count); },
        [&](Index count, const int* values) { std::for_each(values, values + count, add); });
      row.Finish();
    });
}

/// Copies the fractions of the owned cells to a grid that owns the same cells.
FractionField CopyOwned(
  const CartesianGrid& from, const FractionField& fractions, const CartesianGrid& to)
{
  FractionField result(to, fractions.NumberOfMaterials());
  const IndexBox& box = from.Owned();
  const Index3& start = to.Owned().Lower;
  FractionField::RowWriter writer(result);
  ForRows(box,
    [&](Index j, Index k)
    {
      const Index first = from.Linear({ { box.Lower[0], j, k } });
      writer.Start(
        to.Linear({ { start[0], start[1] + j - box.Lower[1], start[2] + k - box.Lower[2] } }));
      fractions.Visit(
        first, first + box.Size(0),
        [&](Index begin, Index end, int label) { writer.AddLabel(label, end - begin); },
        [&](Index begin, Index end)
        {
          for (Index cell = begin; cell < end; ++cell)
          {
            writer.CopyCell(fractions, cell);
          }
        });
      writer.Finish();
    });
  return result;
}

} // namespace

void FillGhosts(const Partition& partition, FractionField& fractions)
{
  partition.ExchangeBoxes([&](const IndexBox& box) { return PackBox(fractions, partition, box); },
    [&](const IndexBox& box, const Bytes& bytes) { UnpackBox(bytes, partition, box, fractions); });
}

void ReplaceGrid(CartesianGrid to, Ranks& ranks, CartesianGrid& grid, FractionField& fractions)
{
  fractions = CopyOwned(grid, fractions, to);
  grid = std::move(to);
  FillGhosts(Partition(grid, ranks), fractions);
}

void WidenGrid(
  const GridLayers& layers, Ranks& ranks, CartesianGrid& grid, FractionField& fractions)
{
  CartesianGrid wide(grid, grid.Owned(), layers.Ghosts, layers.Hexes);
  if (ranks.Any(!(grid.Local() == wide.Local() && grid.HexBox() == wide.HexBox())))
  {
    ReplaceGrid(std::move(wide), ranks, grid, fractions);
  }
}

} // namespace vfm
