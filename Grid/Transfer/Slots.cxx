#include "Transfer/Slots.h"

namespace vfm
{

int SlotTable::Get(Index cell, int fragment, int material)
{
  int before = -1, next = this->Firsts[cell];
  while (next >= 0 && this->Slots[next].Fragment < fragment)
  {
    before = next;
    next = this->Slots[next].Next;
  }
  if (next >= 0 && this->Slots[next].Fragment == fragment)
  {
    return next;
  }
  const int slot = this->Count();
  const Index3 p = this->Grid.Position(cell);
  const Vector3 centre = 0.5 * (this->Grid.NodePoint(p) + this->Grid.NodePoint(CornerOfCell(p, 7)));
  this->Slots.push_back(
    { cell, fragment, material, next, this->Grid.Owned().Contains(p), 0.0, 0.0, centre });
  if (before < 0)
  {
    this->Firsts.Set(cell, slot);
  }
  else
  {
    this->Slots[before].Next = slot;
  }
  return slot;
}

namespace
{

struct SlotName
{
  Index Key; // of its cell
  int Fragment, Material;
  double Overlap;
  Vector3 Centroid;
};

} // namespace

SlotLinks::SlotLinks(const CartesianGrid& grid, const Partition& partition, SlotTable& slots) :
  Parts(&partition)
{
  const auto pack = [&](const IndexBox& box)
  {
    std::vector<SlotName> names;
    this->Mine.emplace_back();
    partition.ForCells(box,
      [&](Index cell)
      {
        slots.ForCell(cell,
          [&](int s)
          {
            this->Mine.back().push_back(s);
            names.push_back({ grid.CellKey(grid.Position(cell)), slots[s].Fragment,
              slots[s].Material, slots[s].Overlap, slots[s].Centroid });
          });
      });
    return ToBytes(names);
  };
  const auto unpack = [&](const IndexBox&, const Bytes& bytes)
  {
    this->Copies.emplace_back();
    for (const SlotName& name : FromBytes<SlotName>(bytes))
    {
      const int s = slots.Get(grid.Linear(grid.CellOfKey(name.Key)), name.Fragment, name.Material);
      slots[s].Overlap = name.Overlap;
      slots[s].Centroid = name.Centroid;
      this->Copies.back().push_back(s);
    }
  };
  partition.ExchangeBoxes(pack, unpack);
}

SlotLinks SlotLinks::Narrow(const std::function<bool(int slot)>& wants) const
{
  SlotLinks narrow = *this;
  std::vector<std::vector<Index>> wanted(this->Copies.size());
  for (std::size_t p = 0; p < this->Copies.size(); ++p)
  {
    narrow.Copies[p].clear();
    for (std::size_t i = 0; i < this->Copies[p].size(); ++i)
    {
      if (wants(this->Copies[p][i]))
      {
        wanted[p].push_back(static_cast<Index>(i));
        narrow.Copies[p].push_back(this->Copies[p][i]);
      }
    }
  }
  const std::vector<std::vector<Index>> asked = this->Parts->Request(wanted);
  for (std::size_t p = 0; p < asked.size(); ++p)
  {
    narrow.Mine[p].clear();
    for (Index i : asked[p])
    {
      narrow.Mine[p].push_back(this->Mine[p][i]);
    }
  }
  return narrow;
}

} // namespace vfm
