/**
 * NodesNear: the nodes of a level near interfaces as runs along x, so that memory is proportional
 * to the interfaces.
 */
#pragma once

#include "Base/CartesianGrid.h"

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

} // namespace vfm
