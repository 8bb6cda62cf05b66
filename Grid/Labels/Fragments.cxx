#include "Labels/Fragments.h"

#include "Base/DisjointSets.h"
#include "Base/Sorted.h"

namespace vfm
{

Fragments::Fragments(
  const CartesianGrid& grid, const LabelArray& labels, bool meshVoid, const Partition& partition) :
  Box(grid.HexBox()), End(this->Box.Upper[0])
{
  this->MakeRuns(grid, labels);
  std::vector<Index> parent = MakeSets(this->Runs.size());
  ForRows(this->Box,
    [&](Index j, Index k)
    {
      if (j > this->Box.Lower[1])
      {
        this->JoinRows(this->Row(j, k), this->Row(j - 1, k), parent);
      }
      if (k > this->Box.Lower[2])
      {
        this->JoinRows(this->Row(j, k), this->Row(j, k - 1), parent);
      }
    });
  const std::vector<Piece> mine = this->FindPieces(grid, parent, meshVoid);
  Ranks& ranks = partition.Group();
  JoinedPieces joined = JoinPieces(
    mine, this->FindSame(grid, partition, OffsetOfRank(ranks)), partition.Peers(), ranks);
  this->Own = std::move(joined.Share);
  for (RunOfCells& run : this->Runs)
  {
    run.Fragment = run.Fragment > 0 ? joined.Fragments[run.Fragment - 1] : 0;
  }
}

void Fragments::MakeRuns(const CartesianGrid& grid, const LabelArray& labels)
{
  this->RowStart.push_back(0);
  ForRows(this->Box,
    [&](Index j, Index k)
    {
      const Index row = grid.Linear({ { this->Box.Lower[0], j, k } });
      const auto add = [&](Index cell, int label)
      {
        if (cell == row || this->Runs.back().Label != label)
        {
          this->Runs.push_back({ this->Box.Lower[0] + cell - row, label, 0 });
        }
      };
      labels.Visit(
        row, row + this->Box.Size(0), [&](Index begin, Index, int label) { add(begin, label); },
        [&](Index begin, Index end, const int* values)
        {
          for (Index cell = begin; cell < end; ++cell)
          {
            add(cell, values[cell - begin]);
          }
        });
      this->RowStart.push_back(static_cast<Index>(this->Runs.size()));
    });
}

void Fragments::JoinRows(Index row, Index other, std::vector<Index>& parent) const
{
  Index a = this->RowStart[row], b = this->RowStart[other];
  const Index aEnd = this->RowStart[row + 1], bEnd = this->RowStart[other + 1];
  while (a < aEnd && b < bEnd)
  {
    if (this->Runs[a].Label == this->Runs[b].Label)
    {
      Join(parent, a, b);
    }
    const Index aNext = a + 1 < aEnd ? this->Runs[a + 1].First : this->End;
    const Index bNext = b + 1 < bEnd ? this->Runs[b + 1].First : this->End;
    a += aNext <= bNext;
    b += bNext <= aNext;
  }
}

/// Returns the local components of this rank's box by their lowest cell. Runs temporarily get 1 +
/// the number of their component.
std::vector<Piece> Fragments::FindPieces(
  const CartesianGrid& grid, std::vector<Index>& parent, bool meshVoid)
{
  std::vector<Piece> pieces;
  Index r = 0;
  ForRows(this->Box,
    [&](Index j, Index k)
    {
      for (; r < this->RowStart[this->Row(j, k) + 1]; ++r)
      {
        RunOfCells& run = this->Runs[r];
        const Index root = FindRoot(parent, r);
        if (root == r && IsMeshed(run.Label, meshVoid))
        {
          pieces.push_back({ grid.CellKey({ { run.First, j, k } }), run.Label });
          run.Fragment = static_cast<int>(pieces.size());
        }
        else
        {
          run.Fragment = root == r ? 0 : this->Runs[root].Fragment;
        }
      }
    });
  return pieces;
}

/// Returns the pairs of local components of different ranks that contain the same cell. Components
/// of this rank are numbered from offset.
PiecePairs Fragments::FindSame(
  const CartesianGrid& grid, const Partition& partition, Index offset) const
{
  PiecePairs same;
  if (partition.Peers().empty())
  {
    return same;
  }
  PagedArray<Index> pieceOf(grid, -1);
  ForRows(this->Box,
    [&](Index j, Index k)
    {
      const Index row = grid.Linear({ { 0, j, k } });
      this->ForRuns(j, k,
        [&](Index first, Index last, int fragment)
        { pieceOf.Fill(row + first, row + last, fragment > 0 ? offset + fragment - 1 : -1); });
    });
  const auto mine = pieceOf;
  partition.ExchangeCells(pieceOf,
    [&](Index cell)
    {
      const std::array<Index, 2> pair{ { mine[cell], pieceOf[cell] } };
      if (pair[0] >= 0 && (same.empty() || same.back() != pair))
      {
        same.push_back(pair);
      }
    });
  SortUnique(same);
  return same;
}

int Fragments::FragmentOfCell(const Index3& cell) const
{
  Index runEnd;
  return this->FragmentOfCell(cell, runEnd);
}

int Fragments::FragmentOfCell(const Index3& cell, Index& runEnd) const
{
  const Index row = this->Row(cell[1], cell[2]);
  const auto first = this->Runs.begin() + this->RowStart[row];
  const auto last = this->Runs.begin() + this->RowStart[row + 1];
  const auto next = std::upper_bound(
    first, last, cell[0], [](Index i, const RunOfCells& run) { return i < run.First; });
  runEnd = next == last ? this->End : next->First;
  return std::prev(next)->Fragment;
}

} // namespace vfm
