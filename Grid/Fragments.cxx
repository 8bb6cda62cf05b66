#include "Fragments.h"

namespace vfm
{
namespace
{

Index FindRoot(std::vector<Index>& parent, Index item)
{
  while (parent[item] != item)
  {
    parent[item] = parent[parent[item]];
    item = parent[item];
  }
  return item;
}

/// The lower root wins, so a root is the lowest run of its piece.
void Join(std::vector<Index>& parent, Index a, Index b)
{
  a = FindRoot(parent, a);
  b = FindRoot(parent, b);
  parent[std::max(a, b)] = std::min(a, b);
}

} // namespace

Fragments::Fragments(const CartesianGrid& grid, const LabelArray& labels, bool meshVoid) :
  Box(grid.Owned()), End(grid.Owned().Upper[0])
{
  this->MakeRuns(grid, labels);
  std::vector<Index> parent(this->Runs.size());
  for (std::size_t r = 0; r < parent.size(); ++r)
  {
    parent[r] = static_cast<Index>(r);
  }
  for (Index k = this->Box.Lower[2]; k < this->Box.Upper[2]; ++k)
  {
    for (Index j = this->Box.Lower[1]; j < this->Box.Upper[1]; ++j)
    {
      if (j > this->Box.Lower[1])
      {
        this->JoinRows(this->Row(j, k), this->Row(j - 1, k), parent);
      }
      if (k > this->Box.Lower[2])
      {
        this->JoinRows(this->Row(j, k), this->Row(j, k - 1), parent);
      }
    }
  }
  this->Number(parent, meshVoid);
}

void Fragments::MakeRuns(const CartesianGrid& grid, const LabelArray& labels)
{
  this->RowStart.push_back(0);
  for (Index k = this->Box.Lower[2]; k < this->Box.Upper[2]; ++k)
  {
    for (Index j = this->Box.Lower[1]; j < this->Box.Upper[1]; ++j)
    {
      const int* row = labels.data() + grid.Linear({ { this->Box.Lower[0], j, k } });
      for (Index i = 0; i < this->Box.Size(0); ++i)
      {
        if (i == 0 || row[i] != row[i - 1])
        {
          this->Runs.push_back({ this->Box.Lower[0] + i, row[i], 0 });
        }
      }
      this->RowStart.push_back(static_cast<Index>(this->Runs.size()));
    }
  }
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

void Fragments::Number(std::vector<Index>& parent, bool meshVoid)
{
  this->Materials.assign(1, 0);
  for (std::size_t r = 0; r < this->Runs.size(); ++r)
  {
    RunOfCells& run = this->Runs[r];
    if (run.Label == 0 && !meshVoid)
    {
      continue;
    }
    const Index root = FindRoot(parent, static_cast<Index>(r));
    if (root == static_cast<Index>(r))
    {
      run.Fragment = static_cast<int>(this->Materials.size());
      this->Materials.push_back(run.Label);
    }
    else
    {
      run.Fragment = this->Runs[root].Fragment;
    }
  }
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
