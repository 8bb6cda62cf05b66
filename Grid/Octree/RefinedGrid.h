/**
 * RefinedGrid: the cells of a grid that stay fine, and the coarser cells that replace the others.
 * Without refinements, all cells stay fine.
 *
 * The stages use the CartesianGrid of the finest level. A cell of the base grid is 2^refinements
 * finest cells along each axis. Where a family of the last refinement is refined
 * (OctantFamilies.h), the finest cells are hexes of their own. Everywhere else are the coarse
 * hexes: coarser cells, and transition hexes between levels (CoarseHexes.h). If all interfaces have
 * finest cells, the stages that find, resolve and move interfaces meet no coarse hexes. Otherwise
 * labels belong to leaves (LeafOf), and interfaces cross coarse hexes too (SplitNodes.h).
 *
 * A rank holds the families of its own part of the grid and around it. Functions return what is
 * true of the whole grid for cells and nodes in the local boxes of both grids.
 */
#pragma once

#include "Base/Options.h"
#include "Octree/OctantFamilies.h"
#include "Ranks/Ranks.h"

#include <memory>

namespace vfm
{

/// Finest and base grid, refined families, and the finest cells that are hexes of their own. Owns
/// copies of both grids. Thread safe once made.
class RefinedGrid : public std::enable_shared_from_this<RefinedGrid>
{
public:
  /// Finds and closes the families that the plan of all ranks and the interfaces require.
  /// @param interfaces  linear indices of nodes of the finest grid that must have fine cells around
  /// them, plan.FineLayers more than the cells at the node. Only nodes at
  /// owned cells count, and only if plan.FineInterfaces.
  /// @throws InputError  if the boxes of the grid are not whole base cells, or keys need more than
  /// 64 bits
  /// @pre Collective.
  RefinedGrid(const CartesianGrid& finest, const LevelPlan& plan,
    const std::vector<Index>& interfaces, Ranks& ranks);
  /// Makes a grid without refinements.
  RefinedGrid(const CartesianGrid& grid, Ranks& ranks) : RefinedGrid(grid, LevelPlan(), {}, ranks)
  {
  }
  RefinedGrid(const RefinedGrid&) = delete;
  RefinedGrid& operator=(const RefinedGrid&) = delete;

  const CartesianGrid& Finest() const { return this->FinestGrid; }
  const CartesianGrid& Base() const { return this->BaseGrid; }
  const OctreeKeys& Lattice() const { return this->TheLattice; }
  const OctantFamilies& Families() const { return this->Sets; }
  int NumberOfRefinements() const { return this->TheLattice.NumberOfRefinements(); }
  /// Returns whether all cells at interfaces are finest ones.
  bool HasFineInterfaces() const { return this->FineInterfaces; }
  /// Returns whether all cells are finest ones, as in a grid without refinements.
  bool IsUniform() const { return this->Uniform; }

  /// Returns whether a finest cell of the local box is a hex of its own. A cell outside the domain
  /// counts as the cell that it mirrors.
  bool IsFine(const Index3& cell) const { return this->Uniform || this->IsMarked(cell); }
  /// Returns whether any cell at a node of the finest grid is a hex of its own.
  bool TouchesFine(const Index3& node) const
  {
    return this->Uniform || this->CountFineAround(node) > 0;
  }

  /// Returns whether all cells at a node of the finest grid are hexes of their own.
  bool IsFineAround(const Index3& node) const
  {
    return this->Uniform || this->CountFineAround(node) == 8;
  }

  /// Returns the leaf that a finest cell of the domain is or lies in: the coarsest cell around it
  /// that is not refined. Its slot is 0.
  OctreeKeys::LevelIndex LeafOf(const Index3& finestCell) const;

  /// Call visit(begin, end) for the runs of cells in [first, last) of row (j, k) that are hexes of
  /// their own, and for the runs of nodes at such cells. Rows without them cost nothing.
  template <class Visitor>
  void ForFineCells(Index j, Index k, Index first, Index last, const Visitor& visit) const;
  template <class Visitor>
  void ForFineNodes(Index j, Index k, Index first, Index last, const Visitor& visit) const;

  /// Returns the finest cells of a cell of a level.
  IndexBox FinestCells(int level, const Index3& cell) const;
  /// Returns the node of the finest grid that is a node of a level.
  Index3 FinestNode(int level, const Index3& node) const;
  /// Returns whether a cell of a level contains or touches owned cells.
  bool IsNear(int level, const Index3& cell) const;
  /// Returns the finest cell of a cell that is nearest to the owned ones.
  Index3 NearestCell(int level, const Index3& cell) const;

private:
  /// Returns a visitor of runs that extends each run by `after` entries and visits its part in
  /// [first, last).
  template <class Visitor>
  static auto CutAt(Index first, Index last, Index after, const Visitor& visit)
  {
    return [=, &visit](Index begin, Index end)
    {
      begin = std::max(begin, first);
      end = std::min(end + after, last);
      if (begin < end)
      {
        visit(begin, end);
      }
    };
  }
  bool IsMarked(const Index3& cell) const;
  /// Returns how many of the eight cells at a node are hexes of their own.
  int CountFineAround(const Index3& node) const;
  std::vector<Index> FindFamilies(
    const std::vector<Index>& interfaces, const LevelPlan& plan) const;
  std::vector<std::vector<Index>> RequestFamilies(
    const LevelPlan& plan, const std::vector<Index>& interfaces) const;
  IndexBox FindPart() const;
  void MarkFine();
  Index RowOfFamilies(Index j, Index k) const;
  template <class Visitor>
  void ForFineFamilies(const std::array<Index, 4>& rows, const Visitor& visit) const;

  CartesianGrid FinestGrid;
  CartesianGrid BaseGrid;
  OctreeKeys TheLattice;
  OctantFamilies Sets;
  // A family of the last refinement has four finest cells along each axis, a cell two.
  int UnitShift;

  bool Uniform, FineInterfaces;
  // Families of the last refinement that cover the local box.
  IndexBox Marked;
  std::vector<unsigned char> Fine;    // whether each of them is refined
  std::vector<unsigned char> HasFine; // whether each row of them has refined ones
};

/// Calls visit(begin, end), in cells, for the runs of families that are refined in any of the rows.
template <class Visitor>
void RefinedGrid::ForFineFamilies(const std::array<Index, 4>& rows, const Visitor& visit) const
{
  const auto hasFine = [this](Index row) { return this->HasFine[row] != 0; };
  if (this->HasFine.empty() || std::none_of(rows.begin(), rows.end(), hasFine))
  {
    return;
  }
  const Index size = this->Marked.Size(0), start = this->Marked.Lower[0];
  const auto isFine = [&](Index q)
  {
    return std::any_of(
      rows.begin(), rows.end(), [&](Index row) { return this->Fine[row * size + q] != 0; });
  };
  for (Index q = 0; q < size; ++q)
  {
    const Index begin = q;
    while (q < size && isFine(q))
    {
      ++q;
    }
    if (q > begin)
    {
      visit((start + begin) << this->UnitShift, (start + q) << this->UnitShift);
    }
  }
}

template <class Visitor>
void RefinedGrid::ForFineCells(
  Index j, Index k, Index first, Index last, const Visitor& visit) const
{
  if (this->IsUniform())
  {
    visit(first, last);
    return;
  }
  const Index row = this->RowOfFamilies(j, k);
  this->ForFineFamilies({ { row, row, row, row } }, CutAt(first, last, 0, visit));
}

template <class Visitor>
void RefinedGrid::ForFineNodes(
  Index j, Index k, Index first, Index last, const Visitor& visit) const
{
  if (this->IsUniform())
  {
    visit(first, last);
    return;
  }
  this->ForFineFamilies({ { this->RowOfFamilies(j - 1, k - 1), this->RowOfFamilies(j, k - 1),
                          this->RowOfFamilies(j - 1, k), this->RowOfFamilies(j, k) } },
    CutAt(first, last, 1, visit));
}

} // namespace vfm
