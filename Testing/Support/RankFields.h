/**
 * Grids and fields, also cut for ranks that are threads; loops on threads.
 */
#pragma once

#include "Base/Partition.h"
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

/// Cuts every loop in ranges that run on several threads in no order.
class ThreadedRuntime : public Runtime
{
public:
  void For(Index first, Index last, const std::function<void(Index, Index)>& body) override;
};

/// Cuts a box in parts along its longest axis each time (axis -1), or along one axis.
std::vector<IndexBox> CutBox(const IndexBox& box, int parts, int axis = -1);

/// The grid of a rank that owns a box.
inline CartesianGrid MakeRankGrid(
  const CartesianGrid& whole, const IndexBox& box, const GridLayers& layers = {})
{
  return CartesianGrid(whole.Coordinates(), box, layers.Ghosts, layers.Hexes);
}

/// The part of a field of the whole grid that a rank holds.
FractionField CopyToLocal(
  const CartesianGrid& whole, const FractionField& from, const CartesianGrid& grid);

/// n cells along each axis; widths vary by up to 1.3 from cell to cell and differ by axis.
CartesianGrid MakeUnevenGrid(int n);

/// Whether both hold the same parts, bit for bit.
bool HaveSameParts(const FractionField& a, Index i, const FractionField& b, Index j);

/// Half of the cells pure, the others of random parts, some of them tiny.
FractionField MakePatchyFractions(const CartesianGrid& grid, int materials, unsigned seed);

/// What changes a field; fractions: of the local box.
using FieldChange = std::function<void(const CartesianGrid& grid, const Partition& partition,
  Runtime& runtime, FractionField& fractions)>;

/// "", or on how many ranks a change gives another field, ghost cells included, than on one. Tries
/// 2, 3, 4 and 8 ranks, slabs, and a rank without cells.
std::string FindRankProblem(
  const CartesianGrid& whole, const FractionField& field, const FieldChange& change);

} // namespace testing
} // namespace vfm
