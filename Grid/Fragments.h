/**
 * Fragments: face-connected pieces of one label.
 */
#pragma once

#include "HexMesh.h"
#include "Labels.h"

namespace vfm
{

/// Piece of every cell, numbered from 1 by the lowest cell; 0 in cells that are not meshed.
/// Stored as runs of equal label along x, so that memory follows the interfaces.
class Fragments
{
public:
  Fragments(const CartesianGrid& grid, const LabelArray& labels, bool meshVoid);

  int NumberOfFragments() const { return static_cast<int>(this->Materials.size()) - 1; }
  /// Of a cell in the owned box. runEnd: set to the end of the row's cells of the same fragment.
  int FragmentOfCell(const Index3& cell) const;
  int FragmentOfCell(const Index3& cell, Index& runEnd) const;
  int MaterialOfFragment(int fragment) const { return this->Materials[fragment]; }

  /// Calls body(first cell, last cell + 1, fragment) for the runs of row (j, k) in order.
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
  void Number(std::vector<Index>& parent, bool meshVoid);

  IndexBox Box;
  Index End;
  std::vector<RunOfCells> Runs;
  std::vector<Index> RowStart;
  std::vector<int> Materials; // by fragment, [0] unused
};

} // namespace vfm
