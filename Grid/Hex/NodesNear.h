/**
 * NodesNear: which nodes of a level lie near interfaces, as runs along x: memory follows the interfaces.
 */
#pragma once

#include "Base/CartesianGrid.h"

namespace vfm
{

class NodesNear
{
public:
  /// mixed: nodes of the finest grid, linear indices; halvings: from the level to it; rings: cells of the level.
  NodesNear(
    const CartesianGrid& finest, const std::vector<Index>& mixed, int halvings, Index rings);

  bool Has(const Index3& node) const;

private:
  struct Run
  {
    Index Begin, End; // IndexInBox
    bool operator<(const Run& other) const { return this->Begin < other.Begin; }
  };
  void Spread(Index stride, Index rings);

  IndexBox Box; // of nodes
  std::vector<Run> Runs;
};

} // namespace vfm
