#include "GhostFractions.h"

namespace vfm
{
namespace
{

using Part = FractionField::Part;

/// A label, or ~(how many parts), of every cell; then the parts.
Bytes PackBox(const FractionField& fractions, const Partition& partition, const IndexBox& box)
{
  std::vector<int> entries;
  std::vector<Part> parts;
  partition.ForCells(box,
    [&](Index cell)
    {
      if (!fractions.IsMixed(cell))
      {
        entries.push_back(fractions.Label(cell));
        return;
      }
      const FractionField::Range own = fractions.Parts(cell);
      entries.push_back(~static_cast<int>(own.end() - own.begin()));
      parts.insert(parts.end(), own.begin(), own.end());
    });
  const Bytes first = ToBytes(entries), rest = ToBytes(parts);
  Bytes bytes(first.size() + rest.size());
  std::copy(rest.begin(), rest.end(), std::copy(first.begin(), first.end(), bytes.begin()));
  return bytes;
}

void UnpackBox(
  const Bytes& bytes, const Partition& partition, const IndexBox& box, FractionField& fractions)
{
  const auto middle = bytes.begin() + box.NumberOfCells() * sizeof(int);
  const std::vector<int> entries = FromBytes<int>(Bytes(bytes.begin(), middle));
  const std::vector<Part> parts = FromBytes<Part>(Bytes(middle, bytes.end()));
  const int* entry = entries.data();
  const Part* part = parts.data();
  partition.ForCells(box,
    [&](Index cell)
    {
      if (*entry >= 0)
      {
        fractions.SetLabel(cell, *entry);
      }
      else
      {
        fractions.CopyParts(cell, { part, part + ~*entry });
        part += ~*entry;
      }
      ++entry;
    });
}

} // namespace

void FillGhosts(const Partition& partition, FractionField& fractions)
{
  partition.ExchangeBoxes([&](const IndexBox& box) { return PackBox(fractions, partition, box); },
    [&](const IndexBox& box, const Bytes& bytes) { UnpackBox(bytes, partition, box, fractions); });
}

} // namespace vfm
