/**
 * CellVolumes: sums of volumes and areas by cell and material.
 *
 * They are sums of integers, so they depend on neither their order nor ranks.
 */
#pragma once

#include "Base/Partition.h"

#include <cmath>

namespace vfm
{

/// Volumes of materials in cells of the local box. Keeps a reference to the grid.
class CellVolumes
{
public:
  /// In Quantum mean cells.
  struct Amounts
  {
    std::int64_t Lack = 0;   ///< volume that is missing
    std::int64_t Filled = 0; ///< volume in the fractions
    std::int64_t Area = 0;   ///< of interfaces

    void Add(const Amounts& other)
    {
      this->Lack += other.Lack;
      this->Filled += other.Filled;
      this->Area += other.Area;
    }
  };
  struct Entry
  {
    Index Key; ///< KeyOf
    Amounts Values;
  };

  static constexpr double Quantum = 0x1p-40;

  /// @param materials  number of materials, with void
  CellVolumes(const CartesianGrid& grid, int materials) : Grid(&grid), Materials(materials) {}

  /// Returns a volume or area, in mean cells, as a number of Quantum.
  static std::int64_t Rounded(double value) { return std::llround(value / Quantum); }

  Index KeyOf(Index cell, int material) const { return cell * this->Materials + material; }
  /// Adds to an entry at the end of a list if it has the same key, else appends the new one.
  static void Append(const Entry& entry, std::vector<Entry>& entries);

  /// Add amounts. They count after Unite.
  void Add(Index cell, int material, const Amounts& amounts)
  {
    Append({ this->KeyOf(cell, material), amounts }, this->Entries);
  }
  void Add(const std::vector<Entry>& entries)
  {
    this->Entries.insert(this->Entries.end(), entries.begin(), entries.end());
  }
  void Unite();

  /// Adds the sums of other ranks, so that those of all cells of the local box are complete.
  /// @pre Collective among peers. United before.
  void Complete(const Partition& parts);

  /// Calls visit(i, amounts) for the cells i of a row that have amounts of a material.
  /// @param first  cell 0; the row extends along x. Cells outside the local box are left out.
  /// @pre United.
  template <class Visit>
  void ForRow(const Index3& first, Index count, int material, const Visit& visit) const
  {
    const IndexBox& box = this->Grid->Local();
    const Index begin = std::max<Index>(0, box.Lower[0] - first[0]);
    const Index end = std::min(count, box.Upper[0] - first[0]);
    if (begin >= end || !box.Contains({ { first[0] + begin, first[1], first[2] } }))
    {
      return;
    }
    const Index origin = this->Grid->Linear(first);
    const Index last = this->KeyOf(origin + end, 0);
    for (auto at = this->FirstFrom(this->KeyOf(origin + begin, 0));
         at != this->Entries.end() && at->Key < last; ++at)
    {
      if (at->Key % this->Materials == material)
      {
        visit(at->Key / this->Materials - origin, at->Values);
      }
    }
  }

private:
  struct Item; // an entry for another rank

  std::vector<Entry>::const_iterator FirstFrom(Index key) const;
  void SendToOwners(const Partition& parts);
  void SendToGhosts(const Partition& parts);

  const CartesianGrid* Grid;
  Index Materials;
  std::vector<Entry> Entries;  // after Unite ascending, one per key
  std::vector<Index> RowStart; // number of the first entry of each row of cells along x
};

} // namespace vfm
