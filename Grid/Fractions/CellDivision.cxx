#include "Fractions/CellDivision.h"

#include "Base/GlobalIds.h"
#include "Base/Runtime.h"

#include <cmath>
#include <limits>
#include <numeric>
#include <sstream>

namespace vfm
{
namespace
{

constexpr double Slack = 1e-3; // relative to the aspect ratio; widths are not more accurate

/// Widths of the layers along an axis, and the number of parts of each.
struct Layers
{
  std::vector<double> Widths, Parts; // Parts: double, because an Index may be too small

  explicit Layers(const std::vector<double>& nodes) : Parts(nodes.size() - 1, 1.0)
  {
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
    {
      this->Widths.push_back(nodes[i + 1] - nodes[i]);
    }
  }
  double SmallestWidth() const
  {
    double smallest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < this->Widths.size(); ++i)
    {
      smallest = std::min(smallest, this->Widths[i] / this->Parts[i]);
    }
    return smallest;
  }
  double NumberOfParts() const
  {
    return std::accumulate(this->Parts.begin(), this->Parts.end(), 0.0);
  }
  /// Divides layers until no width exceeds the largest; returns whether that needed more parts.
  bool Cut(double largest)
  {
    bool hasMore = false;
    for (std::size_t i = 0; i < this->Widths.size(); ++i)
    {
      const double requested = std::ceil(this->Widths[i] / largest * (1.0 - Slack));
      hasMore = hasMore || requested > this->Parts[i];
      this->Parts[i] = std::max(this->Parts[i], requested);
    }
    return hasMore;
  }
};

void CheckNumberOfParts(const std::vector<Layers>& axes, double maximumAspectRatio)
{
  double ids = static_cast<double>(TetIds.ElementSlots);
  for (const Layers& layers : axes)
  {
    ids *= layers.NumberOfParts() + 1.0;
  }
  if (!(ids < static_cast<double>(std::numeric_limits<Index>::max())))
  {
    std::ostringstream text;
    text << "Cells cut until no aspect ratio is above " << maximumAspectRatio
         << " have more nodes than 64-bit global ids can number. Allow a larger aspect ratio.";
    throw InputError(text.str());
  }
}

} // namespace

CellDivision::CellDivision(const std::array<std::vector<Index>, 3>& parts)
{
  const auto isWhole = [](Index n) { return n == 1; };
  if (std::all_of(parts.begin(), parts.end(),
        [&](const std::vector<Index>& along)
        { return std::all_of(along.begin(), along.end(), isWhole); }))
  {
    return;
  }
  for (int a = 0; a < 3; ++a)
  {
    this->First[a].push_back(0);
    for (Index n : parts[a])
    {
      this->First[a].push_back(this->First[a].back() + n);
    }
  }
}

CellDivision::CellDivision(const Index3& cells, Index parts) :
  CellDivision(std::array<std::vector<Index>, 3>{ { std::vector<Index>(cells[0], parts),
    std::vector<Index>(cells[1], parts), std::vector<Index>(cells[2], parts) } })
{
}

Index3 CellDivision::Parts(const Index3& cell) const
{
  Index3 parts{ { 1, 1, 1 } };
  for (int a = 0; !this->IsNone() && a < 3; ++a)
  {
    parts[a] = this->First[a][cell[a] + 1] - this->First[a][cell[a]];
  }
  return parts;
}

IndexBox CellDivision::Divide(const IndexBox& box) const
{
  if (this->IsNone())
  {
    return box;
  }
  IndexBox divided;
  for (int a = 0; a < 3; ++a)
  {
    divided.Lower[a] = this->First[a][box.Lower[a]];
    divided.Upper[a] = this->First[a][box.Upper[a]];
  }
  return divided;
}

std::array<std::vector<double>, 3> CellDivision::Divide(
  std::array<std::vector<double>, 3> coordinates) const
{
  for (int a = 0; !this->IsNone() && a < 3; ++a)
  {
    std::vector<Index> parts(this->First[a].size());
    std::adjacent_difference(this->First[a].begin(), this->First[a].end(), parts.begin());
    parts.erase(parts.begin());
    coordinates[a] = DivideWidths(coordinates[a], parts);
  }
  return coordinates;
}

Index3 CellDivision::ParentOf(const Index3& part) const
{
  Index3 cell = part;
  for (int a = 0; !this->IsNone() && a < 3; ++a)
  {
    const std::vector<Index>& first = this->First[a];
    cell[a] = std::upper_bound(first.begin(), first.end(), part[a]) - first.begin() - 1;
  }
  return cell;
}

CellDivision CellDivision::OfHalves(int times) const
{
  std::array<std::vector<Index>, 3> parts;
  for (int a = 0; !this->IsNone() && a < 3; ++a)
  {
    for (std::size_t i = 0; i + 1 < this->First[a].size(); ++i)
    {
      parts[a].insert(
        parts[a].end(), std::size_t(1) << times, this->First[a][i + 1] - this->First[a][i]);
    }
  }
  return CellDivision(parts);
}

std::vector<double> DivideWidths(const std::vector<double>& nodes, const std::vector<Index>& parts)
{
  std::vector<double> divided;
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    for (Index p = 0; p < parts[i]; ++p)
    {
      const double t = static_cast<double>(p) / static_cast<double>(parts[i]);
      divided.push_back(nodes[i] + t * (nodes[i + 1] - nodes[i]));
    }
  }
  divided.push_back(nodes.back());
  return divided;
}

CellDivision DivideLongCells(
  const std::array<std::vector<double>, 3>& coordinates, double maximumAspectRatio)
{
  std::vector<Layers> axes(coordinates.begin(), coordinates.end());
  bool hasMore = true;
  while (hasMore)
  {
    hasMore = false;
    for (int a = 0; a < 3; ++a)
    {
      const double narrowest =
        std::min(axes[(a + 1) % 3].SmallestWidth(), axes[(a + 2) % 3].SmallestWidth());
      hasMore = axes[a].Cut(maximumAspectRatio * narrowest) || hasMore;
    }
    CheckNumberOfParts(axes, maximumAspectRatio);
  }
  std::array<std::vector<Index>, 3> parts;
  for (int a = 0; a < 3; ++a)
  {
    parts[a].assign(axes[a].Parts.begin(), axes[a].Parts.end());
  }
  return CellDivision(parts);
}

} // namespace vfm
