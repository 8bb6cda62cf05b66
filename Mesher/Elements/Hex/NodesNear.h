/**
 * NodesNear: the nodes of a level near interfaces as runs along x, so that memory is proportional
 * to the interfaces.
 */
#pragma once

#include "Base/CartesianGrid.h"

#include <algorithm>
#include <vector>

namespace vfm
{

/// Set of nodes of one level. Thread safe once made.
class NodesNear
{
public:
  /// Finds the nodes within some cells of the mixed nodes.
  /// @param mixed  linear indices of nodes of the finest grid
  /// @param halvings  number of levels from this level to the finest
  /// @param rings  distance in cells of the level
  NodesNear(
    const CartesianGrid& finest, const std::vector<Index>& mixed, int halvings, Index rings);

  bool Has(const Index3& node) const;
  /// Calls visit(begin, end) for the runs of these nodes in row (j, k), in order.
  template <class Visitor>
  void ForRuns(Index j, Index k, const Visitor& visit) const;

private:
  struct Run
  {
    Index Begin, End; // positions by IndexInBox
    bool operator<(const Run& other) const { return this->Begin < other.Begin; }
  };
  static void AddRun(const Run& run, std::vector<Run>& runs);
  void Spread(Index stride, Index rings);

  IndexBox Box; // box of nodes
  std::vector<Run> Runs;
};

template <class Visitor>
void NodesNear::ForRuns(Index j, Index k, const Visitor& visit) const
{
  const Index3 first{ { this->Box.Lower[0], j, k } };
  if (!this->Box.Contains(first))
  {
    return;
  }
  const Index row = IndexInBox(this->Box, first), end = row + this->Box.Size(0);
  auto run = std::partition_point(
    this->Runs.begin(), this->Runs.end(), [row](const Run& r) { return r.End <= row; });
  for (; run != this->Runs.end() && run->Begin < end; ++run)
  {
    visit(first[0] + std::max(run->Begin, row) - row, first[0] + std::min(run->End, end) - row);
  }
}

} // namespace vfm
