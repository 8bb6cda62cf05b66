#include "Fractions/CellOverlaps.h"

#include <cmath>

namespace vfm
{
namespace
{

constexpr double EqualWidths = 1e-3; // largest difference of widths that count as equal
constexpr double SameNode = 1e-6;    // closer nodes, in cells, become equal

bool HasEqualWidths(const std::vector<double>& nodes)
{
  const double mean = (nodes.back() - nodes.front()) / static_cast<double>(nodes.size() - 1);
  for (std::size_t i = 1; i < nodes.size(); ++i)
  {
    if (std::fabs(nodes[i] - nodes[i - 1] - mean) > EqualWidths * mean)
    {
      return false;
    }
  }
  return true;
}

/// Returns a position, or the node next to it.
double MoveToNode(double x, const std::vector<double>& nodes)
{
  const std::size_t above = std::upper_bound(nodes.begin(), nodes.end(), x) - nodes.begin();
  const std::size_t i = std::min(std::max<std::size_t>(above, 1), nodes.size() - 1);
  const double low = nodes[i - 1], high = nodes[i];
  const double distance = SameNode * (high - low);
  return x - low < distance ? low : high - x < distance ? high : x;
}

/// Finds the overlaps of the cells [first, last).
AxisOverlaps FindOnAxis(
  const std::vector<double>& from, const std::vector<double>& to, Index first, Index last)
{
  AxisOverlaps overlaps(first);
  std::vector<double> shares;
  for (Index cell = first; cell < last; ++cell)
  {
    const double low = to[cell], high = to[cell + 1];
    Index i = std::upper_bound(from.begin(), from.end(), low) - from.begin() - 1;
    const Index begin = i;
    shares.clear();
    do
    {
      const double overlap = std::min(high, from[i + 1]) - std::max(low, from[i]);
      shares.push_back(overlap / (high - low));
      ++i;
    } while (from[i] < high);
    overlaps.Add(begin, shares);
  }
  return overlaps;
}

} // namespace

void AxisOverlaps::Add(Index begin, const std::vector<double>& shares)
{
  this->Begins.push_back(begin);
  this->Shares.insert(this->Shares.end(), shares.begin(), shares.end());
  this->Offsets.push_back(static_cast<Index>(this->Shares.size()));
}

Index AxisOverlaps::EndWithin(Index node) const
{
  Index lower = this->First, upper = this->Upper();
  while (lower < upper)
  {
    const Index middle = (lower + upper) / 2;
    const bool isWithin = this->Of(middle).End <= node;
    lower = isWithin ? middle + 1 : lower;
    upper = isWithin ? upper : middle;
  }
  return lower;
}

Index AxisOverlaps::EndBefore(Index node) const
{
  return this->First +
    (std::lower_bound(this->Begins.begin(), this->Begins.end(), node) - this->Begins.begin());
}

IndexBox Overlapped(const CellOverlaps& overlaps, const IndexBox& cells)
{
  IndexBox box;
  for (int a = 0; cells.NumberOfCells() > 0 && a < 3; ++a)
  {
    box.Lower[a] = overlaps[a].Of(cells.Lower[a]).Begin;
    box.Upper[a] = overlaps[a].Of(cells.Upper[a] - 1).End;
  }
  return box;
}

CellOverlaps OverlapsOfBlocks(
  const CartesianGrid& grid, int halvings, const CartesianGrid& coarse, const IndexBox& cells)
{
  const Index factor = Index(1) << halvings;
  CellOverlaps overlaps;
  std::vector<double> shares(factor);
  for (int a = 0; a < 3; ++a)
  {
    overlaps[a] = AxisOverlaps(cells.Lower[a]);
    for (Index cell = cells.Lower[a]; cell < cells.Upper[a]; ++cell)
    {
      for (Index i = 0; i < factor; ++i)
      {
        shares[i] = grid.Width(a, cell * factor + i) / coarse.Width(a, cell);
      }
      overlaps[a].Add(cell * factor, shares);
    }
  }
  return overlaps;
}

CellOverlaps FindOverlaps(const std::array<std::vector<double>, 3>& from,
  const std::array<std::vector<double>, 3>& to, const IndexBox& cells)
{
  CellOverlaps overlaps;
  for (int a = 0; a < 3; ++a)
  {
    overlaps[a] = FindOnAxis(from[a], to[a], cells.Lower[a], cells.Upper[a]);
  }
  return overlaps;
}

Index CountEqualCells(double length, double width)
{
  return std::max<Index>(std::llround(length / width), 1);
}

std::vector<double> ReplaceNodes(const std::vector<double>& nodes, double width)
{
  const double length = nodes.back() - nodes.front();
  const Index before = static_cast<Index>(nodes.size()) - 1;
  const Index count = CountEqualCells(length, width);
  const bool isEven = HasEqualWidths(nodes);
  std::vector<double> replaced{ nodes.front() };
  for (Index c = 1; c < count; ++c)
  {
    const Index cell = c * before / count, rest = c * before % count;
    const double part = static_cast<double>(rest) / static_cast<double>(count);
    const double share = static_cast<double>(c) / static_cast<double>(count);
    replaced.push_back(isEven
        ? (rest == 0 ? nodes[cell] : nodes[cell] + part * (nodes[cell + 1] - nodes[cell]))
        : MoveToNode(nodes.front() + share * length, nodes));
  }
  replaced.push_back(nodes.back());
  return replaced;
}

} // namespace vfm
