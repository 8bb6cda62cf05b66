#include "Transfer/SlotParts.h"

#include <limits>

namespace vfm
{
namespace
{

/// A part of an element in a cell of another rank.
struct SentPart
{
  Index Id, Key; // of the element, of the cell
  int Fragment, Material;
  double Volume;
  Vector3 Centroid;
};

void AddPart(double volume, const Vector3& centroid, Slot& slot, SlotShape& shape)
{
  const Vector3 x = centroid - slot.Centroid;
  slot.Overlap += volume;
  shape.First = shape.First + volume * x;
  for (int a = 0; a < 3; ++a)
  {
    shape.Second[a] += volume * x[a] * x[a];
    shape.Lower[a] = std::min(shape.Lower[a], x[a]);
    shape.Upper[a] = std::max(shape.Upper[a], x[a]);
  }
  shape.Second[3] += volume * x[0] * x[1];
  shape.Second[4] += volume * x[0] * x[2];
  shape.Second[5] += volume * x[1] * x[2];
}

/// To the owners of the cells; what came for mine, by the ids of the elements.
std::vector<SentPart> ExchangeParts(const Mesh& mesh, const SlotParts& parts,
  const CartesianGrid& grid, const Partition& partition, const SlotTable& slots)
{
  std::vector<std::vector<SentPart>> sent(partition.Peers().size());
  for (std::size_t i = 0; !sent.empty() && i < parts.Elements.size(); ++i)
  {
    for (Index p = parts.Cells.Offsets[i]; p < parts.Cells.Offsets[i + 1]; ++p)
    {
      const Slot& slot = slots[parts.Slots[p]];
      if (!slot.IsOwned)
      {
        const Index3 cell = grid.Position(slot.Cell);
        const OverlapPart& part = parts.Cells.Parts[p];
        sent[partition.PeerOfCell(cell)].push_back({ mesh.ElementIds[parts.Elements[i]],
          grid.CellKey(cell), slot.Fragment, slot.Material, part.Volume, part.Centroid });
      }
    }
  }
  std::vector<Bytes> outgoing;
  for (const std::vector<SentPart>& list : sent)
  {
    outgoing.push_back(ToBytes(list));
  }
  std::vector<SentPart> received;
  for (const Bytes& bytes : partition.Group().Exchange(partition.Peers(), outgoing))
  {
    const std::vector<SentPart> list = FromBytes<SentPart>(bytes);
    received.insert(received.end(), list.begin(), list.end());
  }
  std::stable_sort(received.begin(), received.end(),
    [](const SentPart& a, const SentPart& b) { return a.Id < b.Id; });
  return received;
}

} // namespace

SlotParts FindSlotParts(const Mesh& mesh, std::vector<Index> elements, const CartesianGrid& grid,
  const Partition& partition, Runtime& runtime, SlotTable& slots, std::vector<SlotShape>& shapes)
{
  SlotParts parts{ std::move(elements), {}, {} };
  parts.Cells = FindOverlaps(mesh, parts.Elements, grid, runtime);
  parts.Slots.resize(parts.Cells.Parts.size());
  const auto forParts = [&parts](std::size_t i, const auto& body)
  {
    for (Index p = parts.Cells.Offsets[i]; p < parts.Cells.Offsets[i + 1]; ++p)
    {
      body(parts.Elements[i], p);
    }
  };
  for (std::size_t i = 0; i < parts.Elements.size(); ++i)
  {
    forParts(i,
      [&](Index e, Index p)
      {
        const Index3 cell = CellInBox(grid.Local(), parts.Cells.Parts[p].Cell);
        parts.Slots[p] = slots.Get(grid.Linear(cell), mesh.Fragment[e], mesh.Material[e]);
      });
  }
  const std::vector<SentPart> others = ExchangeParts(mesh, parts, grid, partition, slots);
  for (const SentPart& part : others)
  {
    slots.Get(grid.Linear(grid.CellOfKey(part.Key)), part.Fragment, part.Material);
  }
  shapes.resize(slots.Count());
  auto other = others.begin();
  const auto addOthers = [&](Index end)
  {
    for (; other != others.end() && other->Id < end; ++other)
    {
      const int s = slots.Find(grid.Linear(grid.CellOfKey(other->Key)), other->Fragment);
      AddPart(other->Volume, other->Centroid, slots[s], shapes[s]);
    }
  };
  for (std::size_t i = 0; i < parts.Elements.size(); ++i)
  {
    addOthers(mesh.ElementIds[parts.Elements[i]]);
    forParts(i,
      [&](Index, Index p)
      {
        const int s = parts.Slots[p];
        if (slots[s].IsOwned)
        {
          AddPart(parts.Cells.Parts[p].Volume, parts.Cells.Parts[p].Centroid, slots[s],
            shapes[s]);
        }
      });
  }
  addOthers(std::numeric_limits<Index>::max());
  return parts;
}

void CentreShapes(SlotTable& slots, std::vector<SlotShape>& shapes)
{
  for (int s = 0; s < slots.Count(); ++s)
  {
    Slot& slot = slots[s];
    if (slot.Overlap > 0.0)
    {
      SlotShape& shape = shapes[s];
      const Vector3 mean = (1.0 / slot.Overlap) * shape.First;
      slot.Centroid = slot.Centroid + mean;
      const double o = slot.Overlap;
      const Vector3& m = mean;
      const std::array<double, 6> moved{ { m[0] * m[0], m[1] * m[1], m[2] * m[2], m[0] * m[1],
        m[0] * m[2], m[1] * m[2] } };
      for (int i = 0; i < 6; ++i)
      {
        shape.Second[i] -= o * moved[i];
      }
      shape.Lower = shape.Lower - mean;
      shape.Upper = shape.Upper - mean;
    }
  }
}

} // namespace vfm
