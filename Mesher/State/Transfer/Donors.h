/**
 * Donors: the contents of fragments in cells. A donor collects contents of its cell, exchanges
 * contents with other donors of its fragment, and gives them to the elements in the cell. Elements
 * that are not whole cells (WholeElements.h) have donors in all their cells. Whole elements have
 * donors only near mismatch cells (MismatchCells.h) and in
 * fragments that these divide (FlowNodes.h).
 *
 * The owner of a cell processes its donors. Ranks that hold the cell as a ghost have copies.
 */
#pragma once

#include "Base/Partition.h"
#include "Base/Vector3.h"

#include <functional>

namespace vfm
{

/// Contents of a fragment in a cell. Volumes are in length units cubed.
struct Donor
{
  Index Cell; ///< CartesianGrid::Linear
  int Fragment, Material;
  int Next;             ///< next donor of the cell, in the order of fragments, or -1
  bool IsOwned;         ///< whether this rank owns the cell
  bool HasParts;        ///< whether it is a copy that has parts of elements of this rank
  double Volume = 0.0;  ///< volume of material that it contains
  double Overlap = 0.0; ///< volume of the fragment's elements in the cell
  Vector3 Centroid{};   ///< centroid of the overlap; the cell centre until CentreShapes
};

/// Returns the offsets from a cell to the 27 cells around it, in the order of CellAround.
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

/// Donors of the local box of a grid, which must outlive the table. Adding donors may invalidate
/// references to them, but not their numbers.
class DonorTable
{
public:
  explicit DonorTable(const CartesianGrid& grid) : Grid(grid), Firsts(grid, -1) {}

  /// Returns the donor of a fragment in a cell, or -1 if there is none.
  int Find(Index cell, int fragment) const { return this->FindFrom(this->Firsts[cell], fragment); }
  /// Returns the donors of a fragment in the cell below a cell along x, in the cell, and above it;
  /// -1 where there is none.
  std::array<int, 3> FindThree(Index cell, int fragment) const
  {
    const PagedArray<int>::RowView row = this->Firsts.Row(cell);
    const Index i = this->Firsts.InRow(cell);
    std::array<int, 3> three{ { row[i - 1], row[i], row[i + 1] } };
    for (int& donor : three)
    {
      donor = this->FindFrom(donor, fragment);
    }
    return three;
  }
  /// Returns the donor of a fragment in a cell, which is made if there is none.
  int Get(Index cell, int fragment, int material);

  /// Calls body(donor) for the donors of a cell.
  template <class Body>
  void ForCell(Index cell, const Body& body) const
  {
    for (int donor = this->Firsts[cell]; donor >= 0; donor = this->Donors[donor].Next)
    {
      body(donor);
    }
  }

  /// Makes room for a number of new donors, so that fewer are copied. Unused room is never touched.
  void Reserve(std::size_t added) { this->Donors.reserve(this->Donors.size() + added); }

  int Count() const { return static_cast<int>(this->Donors.size()); }
  Donor& operator[](int donor) { return this->Donors[donor]; }
  const Donor& operator[](int donor) const { return this->Donors[donor]; }

private:
  /// Returns the donor of a fragment in the list of a cell that begins with a donor, or -1.
  int FindFrom(int donor, int fragment) const
  {
    while (donor >= 0 && this->Donors[donor].Fragment != fragment)
    {
      donor = this->Donors[donor].Next;
    }
    return donor;
  }

  const CartesianGrid& Grid;
  PagedArray<int> Firsts; // first donor of each cell, or -1
  std::vector<Donor> Donors;
};

/// Links between owned donors and their copies on other ranks. Two ranks list the donors that they
/// share in one order.
class DonorLinks
{
public:
  /// Links all donors in ghost cells, and makes the missing copies.
  /// Copies get overlaps and centroids.
  /// @param partition  must outlive this object
  /// @pre Collective among peers.
  DonorLinks(const CartesianGrid& grid, const Partition& partition, DonorTable& donors);

  /// Returns the links of the copies for which isNeeded(donor) is true.
  /// @pre Collective among peers.
  DonorLinks Narrow(const std::function<bool(int donor)>& isNeeded) const;

  /// Returns the ranks with which donors are exchanged.
  const std::vector<int>& Peers() const { return this->Parts->Peers(); }

  /// Sends numbers of each owned donor to its copies.
  /// @param width  count of numbers per donor
  /// @param pack  pack(donor, numbers) writes the numbers of an owned donor
  /// @param unpack  unpack(donor, numbers) reads the numbers of a copy
  /// @pre Collective among peers.
  template <class Pack, class Unpack>
  void Exchange(int width, const Pack& pack, const Unpack& unpack) const;

  /// Calls body(donor) for the copies, in the order in which Exchange unpacks them.
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
  std::vector<std::vector<int>> Local, Copies; // owned donors and copies, per peer
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
