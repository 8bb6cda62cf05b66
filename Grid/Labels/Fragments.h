/**
 * Fragments: face-connected sets of cells of one label, numbered over all ranks.
 */
#pragma once

#include "Labels/JoinPieces.h"
#include "Labels/Labels.h"

namespace vfm
{

/// Fragment of every cell of CartesianGrid::HexBox, as numbered on this rank (FragmentShare); 0 in
/// cells that are not meshed. Over all ranks, fragments are numbered by their lowest cell. Stored
/// as runs of cells of one label along x, so memory is proportional to the interfaces.
class Fragments
{
public:
  /// Finds the fragments.
  /// @param labels  labels of the cells of the local box
  /// @param meshVoid  whether void forms fragments too
  /// @pre Collective.
  Fragments(
    const CartesianGrid& grid, const LabelArray& labels, bool meshVoid, const Partition& partition);

  /// Returns the number of fragments over all ranks.
  int NumberOfFragments() const { return static_cast<int>(this->Own.Total); }
  /// Returns the fragments of this rank.
  const FragmentShare& Share() const { return this->Own; }
  /// Returns the fragment of a cell in HexBox.
  int FragmentOfCell(const Index3& cell) const;
  /// Also sets runEnd to the index i of the end of the run of cells of this fragment along x.
  int FragmentOfCell(const Index3& cell, Index& runEnd) const;
  /// Returns the material of every fragment; [0] is unused.
  const std::vector<int>& MaterialsOfFragments() const { return this->Own.Materials; }

  /// Calls body(begin, end, fragment) for the runs of row (j, k) in order, with the indices i of
  /// the first cell and of the end.
  template <class Body>
  void ForRuns(Index j, Index k, const Body& body) const
  {
    const Index row = this->Row(j, k);
    for (Index r = this->RowStart[row]; r < this->RowStart[row + 1]; ++r)
    {
      const Index end = r + 1 < this->RowStart[row + 1] ? this->Runs[r + 1].First : this->End;
      body(this->Runs[r].First, end, this->Runs[r].Fragment);
    }
  }

private:
  struct RunOfCells
  {
    Index First; // i of its first cell
    int Label;
    int Fragment;
  };
  Index Row(Index j, Index k) const
  {
    return (k - this->Box.Lower[2]) * this->Box.Size(1) + j - this->Box.Lower[1];
  }
  void MakeRuns(const CartesianGrid& grid, const LabelArray& labels);
  void JoinRows(Index row, Index other, std::vector<Index>& parent) const;
  std::vector<Piece> FindPieces(
    const CartesianGrid& grid, std::vector<Index>& parent, bool meshVoid);
  PiecePairs FindSame(const CartesianGrid& grid, const Partition& partition, Index offset) const;

  IndexBox Box;
  Index End;
  std::vector<RunOfCells> Runs;
  std::vector<Index> RowStart;
  FragmentShare Own;
};

} // namespace vfm
