/**
 * Donors: what a fragment has in a cell. Contents of cells are gathered there, moved between those of a fragment, and given from
 * there to the elements. There are donors only where elements are no whole cells, and near these.
 *
 * The owner of a cell works on its donors; ranks that hold the cell as a ghost have copies.
 */
#pragma once

#include "Base/Partition.h"
#include "Base/Vector3.h"

#include <functional>

namespace vfm
{

struct Donor
{
  Index Cell; ///< CartesianGrid::Linear
  int Fragment, Material;
  int Next;             ///< of the same cell, fragments ascending; -1: none
  bool IsOwned;         ///< its cell is
  double Volume = 0.0;  ///< of the material that it holds
  double Overlap = 0.0; ///< of the fragment's elements in the cell
  Vector3 Centroid{};   ///< of the latter; before that is known, of the cell
};

/// From a cell to the 27 around it, as CellAround.
inline std::array<Index, 27> StepsAround(const CartesianGrid& grid)
{
  std::array<Index, 27> steps;
  for (int n = 0; n < 27; ++n)
  {
    const Index3 step = StepAround(n);
    steps[n] = step[0] * grid.CornerOffset(1) + step[1] * grid.CornerOffset(2) +
      step[2] * grid.CornerOffset(4);
  }
  return steps;
}

class DonorTable
{
public:
  explicit DonorTable(const CartesianGrid& grid) : Grid(grid), Firsts(grid, -1) {}

  /// -1: none.
  int Find(Index cell, int fragment) const
  {
    int donor = this->Firsts[cell];
    while (donor >= 0 && this->Donors[donor].Fragment != fragment)
    {
      donor = this->Donors[donor].Next;
    }
    return donor;
  }
  /// Makes it where there is none.
  int Get(Index cell, int fragment, int material);

  /// Calls body(donor) for those of a cell.
  template <class Body>
  void ForCell(Index cell, const Body& body) const
  {
    for (int donor = this->Firsts[cell]; donor >= 0; donor = this->Donors[donor].Next)
    {
      body(donor);
    }
  }

  int Count() const { return static_cast<int>(this->Donors.size()); }
  Donor& operator[](int donor) { return this->Donors[donor]; }
  const Donor& operator[](int donor) const { return this->Donors[donor]; }

private:
  const CartesianGrid& Grid;
  PagedArray<int> Firsts; // by cell
  std::vector<Donor> Donors;
};

/// Donors that this rank owns and others hold, and those of others that it holds: by peer, in one order on both sides.
class DonorLinks
{
public:
  /// All donors in cells that are held; makes the copies. Collective.
  DonorLinks(const CartesianGrid& grid, const Partition& partition, DonorTable& donors);

  /// Those of the copies that this rank wants. Collective.
  DonorLinks Narrow(const std::function<bool(int donor)>& wants) const;

  /// Sends some numbers of each donor: pack(donor, numbers) of those owned, unpack(donor, numbers) of copies. Collective.
  template <class Pack, class Unpack>
  void Exchange(int width, const Pack& pack, const Unpack& unpack) const;

  /// Calls body(donor) for the copies, as Exchange unpacks them.
  template <class Body>
  void ForCopies(const Body& body) const
  {
    for (const std::vector<int>& copies : this->Copies)
    {
      std::for_each(copies.begin(), copies.end(), body);
    }
  }

private:
  const Partition* Parts;
  std::vector<std::vector<int>> Local, Copies; // by peer
};

template <class Pack, class Unpack>
void DonorLinks::Exchange(int width, const Pack& pack, const Unpack& unpack) const
{
  std::vector<std::vector<double>> all;
  for (const std::vector<int>& mine : this->Local)
  {
    std::vector<double>& numbers = all.emplace_back(mine.size() * width);
    for (std::size_t i = 0; i < mine.size(); ++i)
    {
      pack(mine[i], numbers.data() + i * width);
    }
  }
  all = this->Parts->Exchange(all);
  for (std::size_t p = 0; p < all.size(); ++p)
  {
    for (std::size_t i = 0; i < this->Copies[p].size(); ++i)
    {
      unpack(this->Copies[p][i], all[p].data() + i * width);
    }
  }
}

} // namespace vfm
