/**
 * Grids and fields, also divided among ranks that are threads; loops on threads.
 */
#pragma once

#include "Base/Partition.h"
#include "Labels/Labels.h"
#include "Phases/MeshOfCells.h"
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

/// Divides each loop into ranges that run on several threads in any order.
class ThreadedRuntime : public Runtime
{
public:
  void For(Index first, Index last, const std::function<void(Index, Index)>& body) override;
};

/// Cuts a box along its longest axis each time (axis -1), or along one axis.
std::vector<IndexBox> CutBox(const IndexBox& box, int parts, int axis = -1);

/// Returns the grid of a rank that owns a box.
inline CartesianGrid MakeRankGrid(
  const CartesianGrid& whole, const IndexBox& box, const GridLayers& layers = {})
{
  return CartesianGrid(whole, box, layers.Ghosts, layers.Hexes);
}

/// Returns the part of a field of the whole grid that a rank stores.
FractionField CopyToLocal(
  const CartesianGrid& whole, const FractionField& from, const CartesianGrid& grid);

/// Returns the labels of which meshes are made.
/// @pre Collective.
LabelArray MakeResolvedLabels(const CartesianGrid& grid, const FractionField& fractions,
  const Partition& partition, Runtime& runtime);

/// Returns a grid of n cells along each axis; widths vary by up to 1.3 from
/// cell to cell and differ by axis.
CartesianGrid MakeUnevenGrid(int n);

/// Returns whether both contain bitwise identical parts.
bool HaveSameParts(const FractionField& a, Index i, const FractionField& b, Index j);

/// Returns a field in which half of the cells are pure and the others have
/// random parts, some of them tiny.
FractionField MakePatchyFractions(const CartesianGrid& grid, int materials, unsigned seed);

/// A change of a field; fractions: of the local box.
using FieldChange = std::function<void(const CartesianGrid& grid, const Partition& partition,
  Runtime& runtime, FractionField& fractions)>;

/// Returns an empty string, or the number of ranks on which a change gives another field than on
/// one rank, ghost cells included. Tries 2, 3, 4 and 8 ranks, slabs, and a rank without cells.
std::string FindRankProblem(
  const CartesianGrid& whole, const FractionField& field, const FieldChange& change);

} // namespace testing
} // namespace vfm
