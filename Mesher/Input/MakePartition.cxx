#include "Input/MakePartition.h"

#include "Ranks/Agreement.h"

#include <cmath>

namespace vfm
{
namespace
{

/// A box that belongs to the ranks [First, First + Count).
struct Part
{
  IndexBox Box;
  int First, Count;
};

/// The weights of this rank's cells.
class Weights
{
public:
  Weights(const std::vector<IndexBox>& blocks, std::vector<Index3> interfaceCells) :
    Blocks(blocks), Cells(std::move(interfaceCells)), PartOfCell(this->Cells.size(), 0)
  {
  }

  Index Total() const
  {
    Index total = static_cast<Index>(this->Cells.size()) * InterfaceCellWeight;
    for (const IndexBox& block : this->Blocks)
    {
      total += block.NumberOfCells() * CellWeight;
    }
    return total;
  }

  /// Returns the weights of the planes across axes[p] of each part p with several ranks; they begin
  /// at first[p].
  std::vector<Index> WeighPlanes(const std::vector<Part>& parts, const std::vector<int>& axes,
    const std::vector<Index>& first) const
  {
    std::vector<Index> planes(first.back(), 0);
    for (std::size_t p = 0; p < parts.size(); ++p)
    {
      const int a = axes[p], b = (a + 1) % 3, c = (a + 2) % 3;
      for (std::size_t i = 0; parts[p].Count > 1 && i < this->Blocks.size(); ++i)
      {
        const IndexBox common = Intersect(this->Blocks[i], parts[p].Box);
        for (Index x = common.Lower[a]; x < common.Upper[a]; ++x)
        {
          planes[first[p] + x - parts[p].Box.Lower[a]] +=
            CellWeight * common.Size(b) * common.Size(c);
        }
      }
    }
    for (std::size_t c = 0; c < this->Cells.size(); ++c)
    {
      const int p = this->PartOfCell[c], a = axes[p];
      if (parts[p].Count > 1)
      {
        planes[first[p] + this->Cells[c][a] - parts[p].Box.Lower[a]] += InterfaceCellWeight;
      }
    }
    return planes;
  }

  /// Updates the parts of cells after a cut; halves[p]: index of the first half of part p.
  void Follow(const std::vector<Part>& parts, const std::vector<int>& halves)
  {
    for (std::size_t c = 0; c < this->Cells.size(); ++c)
    {
      int& p = this->PartOfCell[c];
      p = halves[p];
      p += !parts[p].Box.Contains(this->Cells[c]);
    }
  }

private:
  const std::vector<IndexBox>& Blocks;
  std::vector<Index3> Cells;
  std::vector<int> PartOfCell;
};

IndexBox FindBounds(const std::vector<IndexBox>& boxes)
{
  IndexBox bounds;
  for (std::size_t b = 0; b < boxes.size(); ++b)
  {
    for (int a = 0; a < 3; ++a)
    {
      bounds.Lower[a] = b ? std::min(bounds.Lower[a], boxes[b].Lower[a]) : boxes[b].Lower[a];
      bounds.Upper[a] = b ? std::max(bounds.Upper[a], boxes[b].Upper[a]) : boxes[b].Upper[a];
    }
  }
  return bounds;
}

/// Returns whether every rank holds one box and weights are balanced (GoodBalance).
bool IsPartition(const std::vector<IndexBox>& blocks, const Weights& weights, Ranks& ranks)
{
  Index cells = 0;
  for (const IndexBox& block : blocks)
  {
    cells += block.NumberOfCells();
  }
  const bool isBox = cells == FindBounds(blocks).NumberOfCells();
  std::vector<Index> sums{ isBox ? 0 : 1, weights.Total() };
  ranks.Sum(sums);
  const double greatest = ranks.Max(static_cast<double>(weights.Total()));
  return sums[0] == 0 && greatest * ranks.Count() <= GoodBalance * static_cast<double>(sums[1]);
}

int FindLongestAxis(const IndexBox& box)
{
  int longest = 0;
  for (int a = 1; a < 3; ++a)
  {
    longest = box.Size(a) > box.Size(longest) ? a : longest;
  }
  return longest;
}

/// Returns the number of planes whose weight is nearest to a share of the total; each side gets at
/// least one plane if there are two.
Index FindCut(const Index* planes, Index count, double share)
{
  double total = 0.0, sum = 0.0;
  for (Index x = 0; x < count; ++x)
  {
    total += static_cast<double>(planes[x]);
  }
  Index cut = std::min<Index>(count, 1);
  double best = -1.0;
  for (Index x = 1; x < count; ++x)
  {
    sum += static_cast<double>(planes[x - 1]);
    const double miss = std::abs(sum - share * total);
    if (best < 0.0 || miss < best)
    {
      best = miss;
      cut = x;
    }
  }
  return cut;
}

/// Cuts each part that has several ranks.
std::vector<Part> CutParts(const std::vector<Part>& parts, Weights& weights, Ranks& ranks)
{
  std::vector<int> axes, halves;
  std::vector<Index> first{ 0 };
  for (const Part& part : parts)
  {
    axes.push_back(FindLongestAxis(part.Box));
    first.push_back(first.back() + (part.Count > 1 ? part.Box.Size(axes.back()) : 0));
  }
  std::vector<Index> planes = weights.WeighPlanes(parts, axes, first);
  ranks.Sum(planes);
  std::vector<Part> result;
  for (std::size_t p = 0; p < parts.size(); ++p)
  {
    halves.push_back(static_cast<int>(result.size()));
    Part lower = parts[p], upper = parts[p];
    if (lower.Count > 1)
    {
      lower.Count /= 2;
      upper.First += lower.Count;
      upper.Count -= lower.Count;
      const double share = static_cast<double>(lower.Count) / parts[p].Count;
      const Index cut = lower.Box.Lower[axes[p]] +
        FindCut(planes.data() + first[p], first[p + 1] - first[p], share);
      lower.Box.Upper[axes[p]] = upper.Box.Lower[axes[p]] = cut;
      result.push_back(lower);
      result.push_back(upper);
    }
    else
    {
      result.push_back(lower);
    }
  }
  weights.Follow(result, halves);
  return result;
}

} // namespace

void FindInterfaceCells(const IndexBox& box, const RowReader& read, std::vector<Index3>& found)
{
  const Index n = box.Size(0), plane = n * box.Size(1);
  std::vector<int> last(plane),
    row(n); // last: previous rows of this plane, then the remaining rows of the previous plane
  ForRows(box,
    [&](Index j, Index k)
    {
      int* below = last.data() + (j - box.Lower[1]) * n;
      read({ { box.Lower[0], j, k } }, n, row.data());
      for (Index i = 0; i < n; ++i)
      {
        const int material = row[i];
        if (material < 0 || (i > 0 && row[i - 1] != material) ||
          (j > box.Lower[1] && below[i - n] != material) ||
          (k > box.Lower[2] && below[i] != material))
        {
          found.push_back({ { box.Lower[0] + i, j, k } });
        }
      }
      std::copy(row.begin(), row.end(), below);
    });
}

std::vector<IndexBox> MakePartition(const IndexBox& global, const std::vector<IndexBox>& blocks,
  const std::function<std::vector<Index3>()>& findInterfaceCells, Ranks& ranks, bool mayStay)
{
  if (ranks.Count() == 1)
  {
    return { global };
  }
  std::vector<Index3> cells;
  WorkTogether(ranks, [&] { cells = findInterfaceCells(); });
  Weights weights(blocks, std::move(cells));
  if (mayStay && IsPartition(blocks, weights, ranks))
  {
    return GatherItems(ranks, std::vector<IndexBox>{ FindBounds(blocks) });
  }
  std::vector<Part> parts{ { global, 0, ranks.Count() } };
  while (static_cast<int>(parts.size()) < ranks.Count())
  {
    parts = CutParts(parts, weights, ranks);
  }
  std::vector<IndexBox> boxes;
  for (const Part& part : parts)
  {
    boxes.push_back(part.Box);
  }
  return boxes;
}

} // namespace vfm
