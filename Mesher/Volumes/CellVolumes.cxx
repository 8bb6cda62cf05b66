#include "Volumes/CellVolumes.h"

#include <algorithm>

namespace vfm
{

struct CellVolumes::Item
{
  Index Cell; // its key, or its number in a box
  Amounts Values;
  int Material;
};

void CellVolumes::Append(const Entry& entry, std::vector<Entry>& entries)
{
  if (!entries.empty() && entries.back().Key == entry.Key)
  {
    entries.back().Values.Add(entry.Values);
  }
  else
  {
    entries.push_back(entry);
  }
}

/// Sorts the entries and adds up those of one key.
void CellVolumes::Unite()
{
  std::sort(this->Entries.begin(), this->Entries.end(),
    [](const Entry& a, const Entry& b) { return a.Key < b.Key; });
  std::vector<Entry> united;
  united.reserve(this->Entries.size());
  for (const Entry& entry : this->Entries)
  {
    Append(entry, united);
  }
  this->Entries.swap(united);
  const Index keysOfRow = this->Grid->Stride(1) * this->Materials;
  this->RowStart.clear();
  for (Index i = 0; i < static_cast<Index>(this->Entries.size()); ++i)
  {
    this->RowStart.resize(this->Entries[i].Key / keysOfRow + 1, i);
  }
}

/// Returns the first entry with at least a key.
std::vector<CellVolumes::Entry>::const_iterator CellVolumes::FirstFrom(Index key) const
{
  const std::size_t row = key / (this->Grid->Stride(1) * this->Materials);
  const auto startOf = [&](std::size_t r)
  {
    return r < this->RowStart.size() ? this->Entries.begin() + this->RowStart[r]
                                     : this->Entries.end();
  };
  return std::lower_bound(
    startOf(row), startOf(row + 1), key, [](const Entry& entry, Index k) { return entry.Key < k; });
}

void CellVolumes::Complete(const Partition& parts)
{
  if (!parts.Peers().empty())
  {
    this->SendToOwners(parts);
    this->SendToGhosts(parts);
  }
}

void CellVolumes::SendToOwners(const Partition& parts)
{
  std::vector<std::vector<Item>> sent(parts.Peers().size());
  std::vector<Entry> own;
  for (const auto& [key, amounts] : this->Entries)
  {
    const Index3 cell = this->Grid->Position(key / this->Materials);
    if (parts.OwnsCell(cell))
    {
      own.push_back({ key, amounts });
      continue;
    }
    const int peer = parts.PeerOfCell(cell);
    sent[peer].push_back(
      { parts.CellKeyAtPeer(peer, cell), amounts, static_cast<int>(key % this->Materials) });
  }
  this->Entries.swap(own);
  for (const std::vector<Item>& items : parts.Exchange(sent))
  {
    for (const Item& item : items)
    {
      this->Add(this->Grid->Linear(this->Grid->CellOfKey(item.Cell)), item.Material, item.Values);
    }
  }
  this->Unite();
}

void CellVolumes::SendToGhosts(const Partition& parts)
{
  std::vector<Entry> ghosts;
  parts.ExchangeBoxes(
    [&](const IndexBox& box)
    {
      std::vector<Item> items;
      Index number = 0;
      parts.ForCells(box,
        [&](Index cell)
        {
          const Index key = this->KeyOf(cell, 0);
          for (auto at = this->FirstFrom(key);
               at != this->Entries.end() && at->Key < key + this->Materials; ++at)
          {
            items.push_back({ number, at->Values, static_cast<int>(at->Key - key) });
          }
          ++number;
        });
      return ToBytes(items);
    },
    [&](const IndexBox& box, const Bytes& bytes)
    {
      const std::vector<Item> items = FromBytes<Item>(bytes);
      auto next = items.begin();
      Index number = 0;
      parts.ForCells(box,
        [&](Index cell)
        {
          for (; next != items.end() && next->Cell == number; ++next)
          {
            ghosts.push_back({ this->KeyOf(cell, next->Material), next->Values });
          }
          ++number;
        });
    });
  this->Add(ghosts);
  this->Unite();
}

} // namespace vfm
