/**
 * Fragments: face-connected pieces of one label.
 */
#pragma once

#include "Labels/Labels.h"

namespace vfm
{

/// A connected part of a fragment, on one rank.
struct Piece
{
  Index Lowest; ///< id of its lowest cell or element
  Index Label;
};
using PiecePairs = std::vector<std::array<Index, 2>>;

/// The number of this rank's first piece when the pieces of all ranks stand in the order of the ranks. Collective.
Index OffsetOfPieces(Ranks& ranks, Index count);

/// Joins the pieces of all ranks and numbers the fragments from 1 by their lowest cell. same: pairs of pieces (numbers over
/// all ranks) that are one. Returns the fragment of each of mine; materials: of each fragment, [0] unused. Collective.
std::vector<int> NumberFragments(const std::vector<Piece>& mine, const PiecePairs& same,
  Index offset, Ranks& ranks, std::vector<int>& materials);

/// Piece of every cell of HexBox, numbered from 1 over all ranks by the lowest cell; 0 in cells that are not meshed.
/// Stored as runs of equal label along x, so that memory follows the interfaces.
class Fragments
{
public:
  /// Collective. Every rank learns of all pieces of all ranks: 16 bytes a piece and rank that holds a part of it.
  Fragments(
    const CartesianGrid& grid, const LabelArray& labels, bool meshVoid, const Partition& partition);

  int NumberOfFragments() const { return static_cast<int>(this->Materials.size()) - 1; }
  /// Of a cell in HexBox. runEnd: set to the end of the row's cells of the same fragment.
  int FragmentOfCell(const Index3& cell) const;
  int FragmentOfCell(const Index3& cell, Index& runEnd) const;
  /// Of every fragment; [0] unused.
  const std::vector<int>& MaterialsOfFragments() const { return this->Materials; }

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
  std::vector<Piece> FindPieces(
    const CartesianGrid& grid, std::vector<Index>& parent, bool meshVoid);
  PiecePairs FindSame(const CartesianGrid& grid, const Partition& partition, Index offset) const;

  IndexBox Box;
  Index End;
  std::vector<RunOfCells> Runs;
  std::vector<Index> RowStart;
  std::vector<int> Materials; // by fragment, [0] unused
};

} // namespace vfm
