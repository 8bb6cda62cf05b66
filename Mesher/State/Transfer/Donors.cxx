#include "State/Transfer/Donors.h"

namespace vfm
{

int DonorTable::Get(Index cell, int fragment, int material)
{
  int before = -1, next = this->Firsts[cell];
  while (next >= 0 && this->Donors[next].Fragment < fragment)
  {
    before = next;
    next = this->Donors[next].Next;
  }
  if (next >= 0 && this->Donors[next].Fragment == fragment)
  {
    return next;
  }
  const int donor = this->Count();
  const Index3 p = this->Grid.Position(cell);
  const Vector3 centre = 0.5 * (this->Grid.NodePoint(p) + this->Grid.NodePoint(CornerOfCell(p, 7)));
  this->Donors.push_back(
    { cell, fragment, material, next, this->Grid.Owned().Contains(p), false, 0.0, 0.0, centre });
  if (before < 0)
  {
    this->Firsts.Set(cell, donor);
  }
  else
  {
    this->Donors[before].Next = donor;
  }
  return donor;
}

namespace
{

/// Owned donor as it is sent to ranks that make copies.
struct DonorName
{
  Index Key; // key of its cell
  int Fragment, Material;
  double Overlap;
  Vector3 Centroid;
};

} // namespace

DonorLinks::DonorLinks(const CartesianGrid& grid, const Partition& partition, DonorTable& donors) :
  Parts(&partition)
{
  const auto pack = [&](const IndexBox& box)
  {
    std::vector<DonorName> names;
    this->Local.emplace_back();
    partition.ForCells(box,
      [&](Index cell)
      {
        donors.ForCell(cell,
          [&](int s)
          {
            this->Local.back().push_back(s);
            names.push_back({ grid.CellKey(grid.Position(cell)), donors[s].Fragment,
              donors[s].Material, donors[s].Overlap, donors[s].Centroid });
          });
      });
    return ToBytes(names);
  };
  const auto unpack = [&](const IndexBox&, const Bytes& bytes)
  {
    const std::size_t peer = this->Copies.size();
    const Index shift = grid.CellKey(partition.ShiftOf(peer));
    const Vector3 translation = partition.TranslationOf(peer);
    this->Copies.emplace_back();
    for (const DonorName& name : FromBytes<DonorName>(bytes))
    {
      const Index cell = grid.Linear(grid.CellOfKey(name.Key + shift));
      const int s = donors.Get(cell, name.Fragment, name.Material);
      donors[s].Overlap = name.Overlap;
      donors[s].Centroid = name.Centroid + translation;
      this->Copies.back().push_back(s);
    }
  };
  partition.ExchangeBoxes(pack, unpack);
}

DonorLinks DonorLinks::Narrow(const std::function<bool(int donor)>& isNeeded) const
{
  DonorLinks narrow = *this;
  std::vector<std::vector<Index>> requested(this->Copies.size());
  for (std::size_t p = 0; p < this->Copies.size(); ++p)
  {
    narrow.Copies[p].clear();
    for (std::size_t i = 0; i < this->Copies[p].size(); ++i)
    {
      if (isNeeded(this->Copies[p][i]))
      {
        requested[p].push_back(static_cast<Index>(i));
        narrow.Copies[p].push_back(this->Copies[p][i]);
      }
    }
  }
  const std::vector<std::vector<Index>> ofPeers = this->Parts->Exchange(requested);
  for (std::size_t p = 0; p < ofPeers.size(); ++p)
  {
    narrow.Local[p].clear();
    for (Index i : ofPeers[p])
    {
      narrow.Local[p].push_back(this->Local[p][i]);
    }
  }
  return narrow;
}

} // namespace vfm
