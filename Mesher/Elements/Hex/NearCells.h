/**
 * NearCells: the cells of a grid that have a node near interfaces or on a side of the domain, as
 * runs along x.
 */
#pragma once

#include "Elements/CellRuns.h"
#include "Elements/Hex/NodesNear.h"
#include "Labels/Fragments.h"

namespace vfm
{

/// Set of cells of CartesianGrid::HexBox. Thread safe once made.
class NearCells
{
public:
  /// @param grid  must outlive this object
  /// @param mixed  linear indices of all nodes on interfaces
  /// @param rings  distance of nodes from mixed nodes, in cells
  NearCells(const CartesianGrid& grid, const std::vector<Index>& mixed, Index rings) :
    Grid(grid), Nodes(grid, mixed, 0, rings)
  {
  }

  ///@{ Call visit(begin, end) for the runs of these cells in row (j, k) of HexBox, in order, and
  /// for
  /// the runs of nodes of these cells in row (j, k) of nodes.
  template <class Visitor>
  void ForCells(Index j, Index k, const Visitor& visit) const
  {
    Runs runs;
    this->AddCells(j, k, runs);
    Visit(runs, visit);
  }
  template <class Visitor>
  void ForNodes(Index j, Index k, const Visitor& visit) const
  {
    const IndexBox box = this->Grid.HexBox();
    Runs runs, cells;
    for (Index z = std::max(k - 1, box.Lower[2]); z < std::min(k + 1, box.Upper[2]); ++z)
    {
      for (Index y = std::max(j - 1, box.Lower[1]); y < std::min(j + 1, box.Upper[1]); ++y)
      {
        cells.clear();
        this->AddCells(y, z, cells);
        Visit(cells, [&runs](Index begin, Index end) { runs.push_back({ { begin, end + 1 } }); });
      }
    }
    Visit(runs, visit);
  }
  ///@}

private:
  using Runs = std::vector<std::array<Index, 2>>; // begin and end

  /// Adds the cells of a row of HexBox, in any order; runs may overlap.
  void AddCells(Index j, Index k, Runs& runs) const;
  /// Sorts the runs, and visits their union.
  template <class Visitor>
  static void Visit(Runs& runs, const Visitor& visit)
  {
    std::sort(runs.begin(), runs.end());
    for (auto run = runs.begin(); run != runs.end();)
    {
      const Index begin = (*run)[0];
      Index end = begin;
      for (; run != runs.end() && (*run)[0] <= end; ++run)
      {
        end = std::max(end, (*run)[1]);
      }
      visit(begin, end);
    }
  }

  const CartesianGrid& Grid;
  NodesNear Nodes;
};

/// Returns the meshed cells among the owned ones that are not near, with their fragments.
CellRuns ListFarCells(const CartesianGrid& grid, const NearCells& near, const Fragments& fragments);

} // namespace vfm
