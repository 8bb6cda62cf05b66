/**
 * NarrowVoid: the void cells between bodies that are close to each other. Where void is not meshed,
 * these cells get elements nevertheless while points move. The elements stay positive, so bodies
 * cannot overlap across them. They are no part of the finished mesh (BarrierElements.h).
 *
 * A void cell is narrow if any of these holds:
 * - Along an axis it has cells of materials within two cells on both sides.
 * - Along a diagonal of a face or of the cell it has cells of materials beside it on both sides, or
 *   within two cells if cells are not cubes. One part on both sides, as at a concave edge, does not
 *   count.
 * - The 26 cells around it contain parts of materials that are not connected there by faces, in
 *   directions at an angle of 120 degrees or more.
 * - It shares faces with cells of different materials.
 * - It lies between a side of the domain and a material, and shares a face with more material
 *   along another axis.
 *
 * If interfaces cross levels, the same holds for leaves, in units of their width.
 */
#pragma once

#include "Base/Options.h"
#include "Base/Runtime.h"
#include "Labels/Labels.h"
#include "Octree/RefinedGrid.h"

namespace vfm
{

/// Narrow void cells of the local box, and their nodes. Thread safe once made.
class NarrowVoid
{
public:
  /// Makes an object without cells.
  NarrowVoid() = default;
  /// Finds the narrow cells. If all interfaces have finest cells, only finest cells can be narrow.
  /// @param labels  equal within each leaf if interfaces cross levels
  /// @param mixed  all mixed nodes (FindMixedNodes)
  NarrowVoid(const RefinedGrid& levels, const LabelArray& labels, const std::vector<Index>& mixed,
    Runtime& runtime);

  bool IsEmpty() const { return this->Empty; }
  /// Returns whether a cell is narrow. Known in HexBox and one layer around it.
  bool Has(Index cell) const { return !this->Empty && this->Cells[cell] != 0; }
  /// Returns whether a node is a corner of a narrow cell.
  bool Touches(Index node) const { return !this->Empty && this->Nodes[node] != 0; }
  /// Calls visit(begin, end, isNarrow) for runs of [first, last), which is in one row.
  template <class Visitor>
  void ForCells(Index first, Index last, const Visitor& visit) const
  {
    ForRuns(this->Cells, first, last, visit);
  }
  /// Calls visit(begin, end, touches) for runs of nodes of [first, last), which is in one row.
  template <class Visitor>
  void ForNodes(Index first, Index last, const Visitor& visit) const
  {
    ForRuns(this->Nodes, first, last, visit);
  }
  /// Returns the number of narrow cells that this rank owns; leaves count as finest cells.
  Index CountOwned() const { return this->Owned; }

private:
  using Flags = PagedArray<unsigned char>;

  template <class Visitor>
  static void ForRuns(const Flags& flags, Index first, Index last, const Visitor& visit)
  {
    flags.Visit(
      first, last,
      [&](Index begin, Index end, unsigned char flag) { visit(begin, end, flag != 0); },
      [&](Index begin, Index end, const unsigned char* values)
      {
        for (Index at = begin, next; at < end; at = next)
        {
          const unsigned char flag = values[at - begin];
          for (next = at; next < end && values[next - begin] == flag; ++next)
          {
          }
          visit(at, next, flag != 0);
        }
      });
  }
  void Add(const CartesianGrid& grid, const IndexBox& cells);

  bool Empty = true;
  Index Owned = 0;
  Flags Cells, Nodes;
};

/// Returns the void cells that get elements as a barrier: none if void is meshed or no point moves.
/// @param levels,labels,mixed  arguments of NarrowVoid
NarrowVoid FindBarrier(const MeshSettings& options, const RefinedGrid& levels,
  const LabelArray& labels, const std::vector<Index>& mixed, Runtime& runtime);

} // namespace vfm
