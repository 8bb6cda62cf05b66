/**
 * RefinedGrid: which cells of a grid stay fine, and where coarser cells take their place. Without refinements all stay.
 *
 * The stages see the CartesianGrid of the finest level. The base grid's cells are 2^refinements finest ones along each axis.
 * Where a family of the last refinement is refined (OctantFamilies.h) the finest cells are hexes of their own; everywhere else
 * stand the coarse hexes: coarser cells, and the transition hexes between levels (CoarseHexes.h). Where all interfaces get
 * finest cells, what finds, resolves and moves interfaces meets no coarse hexes; otherwise labels belong to leaves (LeafOf), and
 * interfaces run through coarse hexes too (SplitNodes.h).
 */
#pragma once

#include "Base/Options.h"
#include "Octree/OctantFamilies.h"
#include "Ranks/Ranks.h"

#include <memory>

namespace vfm
{

class RefinedGrid : public std::enable_shared_from_this<RefinedGrid>
{
public:
  /// interfaces: the nodes of the finest grid that must have fine cells around, plan.FineLayers more than those at the node;
  /// linear indices, those at owned cells count; none are looked at unless plan.FineInterfaces. Throws InputError when its boxes are not
  /// whole base cells, or keys do not fit. Collective.
  RefinedGrid(const CartesianGrid& finest, const LevelPlan& plan,
    const std::vector<Index>& interfaces, Ranks& ranks);
  /// Without refinements.
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
  /// Whether all cells at interfaces are finest ones.
  bool HasFineInterfaces() const { return this->FineInterfaces; }
  /// Whether all cells are finest ones: a grid without refinements.
  bool IsUniform() const { return this->Uniform; }

  /// Whether a finest cell of the local box, or the one that a cell beside the domain mirrors, is a hex of its own.
  bool IsFine(const Index3& cell) const { return this->Uniform || this->IsMarked(cell); }
  /// Whether a cell at a node of the finest grid is a hex of its own.
  bool TouchesFine(const Index3& node) const
  {
    return this->Uniform || this->CountFineAround(node) > 0;
  }

  /// Whether all of them are.
  bool IsFineAround(const Index3& node) const
  {
    return this->Uniform || this->CountFineAround(node) == 8;
  }

  /// The leaf that a finest cell of the domain is or lies in: the coarsest cell around it that is not refined. Slot 0.
  OctreeKeys::LevelIndex LeafOf(const Index3& finestCell) const;

  /// Calls visit(begin, end) for the runs of such cells in [first, last) of row j, k, and for the runs of nodes at such
  /// cells. Rows without any cost nothing.
  template <class Visitor>
  void ForFineCells(Index j, Index k, Index first, Index last, const Visitor& visit) const;
  template <class Visitor>
  void ForFineNodes(Index j, Index k, Index first, Index last, const Visitor& visit) const;

  /// The finest cells of a cell of a level.
  IndexBox FinestCells(int level, const Index3& cell) const;
  /// The node of the finest grid that a node of a level is.
  Index3 FinestNode(int level, const Index3& node) const;
  /// Whether a cell of a level is one of the owned ones or has a node or more in common with one.
  bool IsNear(int level, const Index3& cell) const;
  /// Of the finest cells of a cell, the one nearest to the owned ones.
  Index3 NearestCell(int level, const Index3& cell) const;

private:
  /// A visitor of runs of cells that visits what of them, and of so many entries after them, lies in [first, last).
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
  /// Of the eight cells at a node.
  int CountFineAround(const Index3& node) const;
  std::vector<Index> FindFamilies(const std::vector<Index>& interfaces, int layers) const;
  std::vector<std::vector<Index>> GatherFamilies(
    const LevelPlan& plan, const std::vector<Index>& interfaces, Ranks& ranks) const;
  void MarkFine();
  Index RowOfFamilies(Index j, Index k) const;
  template <class Visitor>
  void ForFineFamilies(const std::array<Index, 4>& rows, const Visitor& visit) const;

  CartesianGrid FinestGrid;
  CartesianGrid BaseGrid;
  OctreeKeys TheLattice;
  OctantFamilies Sets;
  static constexpr int FamilyShift = 2; // a family is four finest cells along each axis

  bool Uniform, FineInterfaces;
  IndexBox Marked;                    // families of the last refinement over the local box
  std::vector<unsigned char> Fine;    // of each of them
  std::vector<unsigned char> HasFine; // of each row of them
};

/// Calls visit(begin, end) for the runs of families where one of some rows is refined, in cells.
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
      visit((start + begin) << FamilyShift, (start + q) << FamilyShift);
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
