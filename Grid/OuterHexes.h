/**
 * OuterHexes: the hexes of a refined grid that are no finest cells: coarser cells, and transition hexes between levels.
 * Each lies in a cell of its level, and has the label of that cell.
 *
 * Made for the owned base cells and those around them; a rank keeps its own at the end (KeepOwned).
 * Order: points and hexes by their keys in RefinedLattice, after those of the finest cells; ids ascend among the owned.
 */
#pragma once

#include "Labels.h"
#include "RefinedGrid.h"
#include "Runtime.h"
#include "TwoRefinement.h"

namespace vfm
{

class OuterHexes
{
public:
  /// Makes and smooths the transitions. Only hexes of labels that are meshed count. Collective. Throws InputError as
  /// SmoothTransitions does; asCubes as there.
  OuterHexes(const RefinedGrid& grid, const LabelArray& labels, bool meshVoid, Runtime& runtime,
    bool asCubes = false);

  const RefinedGrid& Levels() const { return this->Grid; }
  /// What they are made of. After Fill only the keys and places of the points, and the touched cells.
  const RefinedMesh& Refined() const { return this->TheRefined; }
  /// Of those that no finest cell of HexBox has.
  Index NumberOfPoints() const { return this->PointCount; }
  Index NumberOfHexes() const { return this->HexCount; }

  /// The index of the mesh point of a node of the finest grid that a finest cell has.
  using FinePoint = std::function<Index(const Index3&)>;
  /// Writes points, hexes, their ids and materials into a mesh, from those positions on. Once only.
  void Fill(Mesh& mesh, Index firstPoint, Index firstHex, const FinePoint& finePoint);

private:
  static constexpr int Unused = -1, Used = -2, Fine = -3;

  class Writer;

  int LabelOf(const RefinedLattice::Place& cell) const;
  bool IsWanted(const RefinedLattice::Place& cell) const;
  int& NumberOf(Index point, const RefinedLattice::Place& place);
  int Sort(int level, const Index3& node) const;
  void DropParts();
  void MarkPoints();
  void NumberPoints();
  template <class OnCell, class OnHex>
  void ForHexes(const OnCell& onCell, const OnHex& onHex) const;
  template <class Visitor>
  void ForPoints(const Visitor& visit);

  const RefinedGrid& Grid;
  const LabelArray& Labels;
  bool MeshVoid;
  RefinedMesh TheRefined;            // without the finest cells; wanted or not
  std::vector<unsigned char> Wanted; // of each hex of TheRefined
  Buffer<int> NodeNumber;            // of base nodes: index of the point, or what it is
  std::vector<int> PointNumber;      // of points of TheRefined that are no base nodes
  Index PointCount = 0, HexCount = 0;
};

} // namespace vfm
