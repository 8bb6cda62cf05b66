/**
 * Grids and fields cut for ranks that are threads.
 */
#pragma once

#include "HexPipeline.h"
#include "ThreadRanks.h"

namespace vfm
{
namespace testing
{

class RankRuntime : public Runtime
{
public:
  explicit RankRuntime(Ranks& ranks) : TheRanks(ranks) {}
  Ranks& Group() override { return this->TheRanks; }

private:
  Ranks& TheRanks;
};

/// Cuts a box in parts along its longest axis each time (axis -1), or along one axis. Adds them to boxes.
void CutBox(const IndexBox& box, int parts, int axis, std::vector<IndexBox>& boxes);

/// The grid of a rank that owns a box.
inline CartesianGrid MakeRankGrid(const CartesianGrid& whole, const IndexBox& box)
{
  return CartesianGrid(
    { { whole.Coordinates(0), whole.Coordinates(1), whole.Coordinates(2) } }, box, GhostLevels);
}

/// The part of a field of the whole grid that a rank holds.
FractionField CopyToLocal(
  const CartesianGrid& whole, const FractionField& from, const CartesianGrid& grid);

} // namespace testing
} // namespace vfm
