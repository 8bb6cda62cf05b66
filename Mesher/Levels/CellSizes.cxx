#include "Levels/CellSizes.h"

#include "Base/ParseText.h"
#include "Fractions/CellOverlaps.h"
#include "Input/NodeCoordinates.h"
#include "Ranks/Errors.h"

#include <cmath>

namespace vfm
{
namespace
{

constexpr Index FewestPeriodic = 4;  // coarsest cells along a periodic axis
constexpr double Tolerance = 1.1;    // of widths, because cells fill the domain exactly
constexpr double MostWidened = 1.25; // of finest cells, so that coarsest cells fill the domain

double Least(const Vector3& widths)
{
  return *std::min_element(widths.begin(), widths.end());
}

/// Returns how often a width can be halved without getting narrower than another.
int CountHalvings(double from, double to)
{
  return std::max(0, static_cast<int>(std::floor(std::log2(Tolerance * from / to))));
}

/// Returns the widths of the cells of materials without their own.
Vector3 OtherWidths(const Vector3& widths, const Vector3& ofInput)
{
  Vector3 others;
  for (int a = 0; a < 3; ++a)
  {
    others[a] = widths[a] > 0.0 ? widths[a] : ofInput[a];
  }
  return others;
}

/// Returns the number of coarsest cells along an axis. A periodic axis of several levels needs an
/// even number.
Index CountCoarsest(Index finest, double length, double width, int halvings, bool repeats)
{
  const Index most = finest >> halvings;
  const Index count = std::min(CountEqualCells(length, width), most);
  return repeats && halvings > 0 ? std::min((count + 1) / 2, most / 2) * 2 : count;
}

void CheckFinest(const Vector3& finest, const Vector3& ofInput, double width)
{
  for (int a = 0; a < 3; ++a)
  {
    if (Tolerance * finest[a] < ofInput[a])
    {
      throw InputError("MaterialWidths contains the width " + FormatNumber(width) +
        ", which gives cells of width " + FormatNumber(finest[a]) + " along " + AxisNames[a] +
        ", and those of the input are " + FormatNumber(ofInput[a]) +
        " wide: it makes cells wider, not narrower. Refinement makes narrower cells.");
    }
  }
}

} // namespace

CellSizes PlanSizes(const GridNodes& nodes, const Vector3& widths,
  const std::vector<double>& ofMaterial, const std::array<bool, 3>& repeats)
{
  const Vector3 ofInput = MeanWidths(nodes), others = OtherWidths(widths, ofInput);
  const auto own = [&](std::size_t m)
  { return std::isinf(ofMaterial[m]) ? Least(others) : ofMaterial[m]; };
  double narrowest = std::isinf(ofMaterial[0]) ? HUGE_VAL : ofMaterial[0];
  double widest = std::isinf(ofMaterial[0]) ? 0.0 : ofMaterial[0];
  for (std::size_t m = 1; m < ofMaterial.size(); ++m)
  {
    narrowest = std::min(narrowest, own(m));
    widest = std::max(widest, own(m));
  }
  Vector3 finest;
  for (int a = 0; a < 3; ++a)
  {
    finest[a] = narrowest * others[a] / Least(others);
  }
  CheckFinest(finest, ofInput, narrowest);
  CellSizes sizes;
  sizes.Halvings = LimitHalvings(nodes, finest, CountHalvings(widest, narrowest), repeats);
  sizes.Nodes = PlaceNodes(nodes, finest, sizes.Halvings, repeats);
  for (std::size_t m = 0; m < ofMaterial.size(); ++m)
  {
    const bool isFree = m == 0 && std::isinf(ofMaterial[0]);
    const int wider = isFree ? sizes.Halvings : CountHalvings(own(m), narrowest);
    sizes.OfMaterial.push_back(std::max(sizes.Halvings - wider, 0));
  }
  return sizes;
}

GridNodes PlaceNodes(
  const GridNodes& nodes, const Vector3& finest, int halvings, const std::array<bool, 3>& repeats)
{
  GridNodes placed;
  for (int a = 0; a < 3; ++a)
  {
    const double length = nodes[a].back() - nodes[a].front();
    const Index cells = static_cast<Index>(nodes[a].size()) - 1;
    const Index count =
      CountCoarsest(cells, length, std::ldexp(finest[a], halvings), halvings, repeats[a]);
    placed[a] = ReplaceNodes(nodes[a], length / static_cast<double>(count << halvings));
  }
  return placed;
}

int LimitHalvings(
  const GridNodes& nodes, const Vector3& finest, int halvings, const std::array<bool, 3>& repeats)
{
  const auto areTooWide = [&](int number)
  {
    const Vector3 placed = MeanWidths(PlaceNodes(nodes, finest, number, repeats));
    return placed[0] > MostWidened * finest[0] || placed[1] > MostWidened * finest[1] ||
      placed[2] > MostWidened * finest[2];
  };
  int limited = std::min(halvings, CountDoublings(nodes, repeats));
  while (limited > 0 && areTooWide(limited))
  {
    --limited;
  }
  return limited;
}

int CountDoublings(const GridNodes& nodes, const std::array<bool, 3>& repeats)
{
  int doublings = std::numeric_limits<int>::max();
  for (int a = 0; a < 3; ++a)
  {
    const Index fewest = repeats[a] ? FewestPeriodic : 1;
    int own = 0;
    for (Index cells = static_cast<Index>(nodes[a].size()) - 1; cells / 2 >= fewest; cells /= 2)
    {
      ++own;
    }
    doublings = std::min(doublings, own);
  }
  return doublings;
}

std::vector<double> WidthsOfMaterials(const CellSizes& sizes)
{
  const Vector3 finest = MeanWidths(sizes.Nodes);
  std::vector<double> widths;
  for (const int halvings : sizes.OfMaterial)
  {
    widths.push_back(
      std::ldexp(*std::max_element(finest.begin(), finest.end()), sizes.Halvings - halvings));
  }
  return widths;
}

} // namespace vfm
