#include "Levels/GreyLabels.h"

#include "Input/ArrayNames.h"
#include "Input/InputArrays.h"
#include "Ranks/Agreement.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

namespace vfm
{
namespace
{

// Measured in 24^3 cells: a ball with a soft border and noise from 0 to 6 has at least 0.96 of thin
// labels and 0.5 of busy cells; grains of 10 and 35 cells have 0.84 and 0.20 of thin labels.
constexpr Index LeastLabels = 32;  // labels of an image that is examined
constexpr double ThinLabel = 0.8;  // share of busy cells
constexpr double ThinLabels = 0.9; // share of thin labels
constexpr double BusyCells = 0.1;  // share of busy cells of all labels
constexpr Index LeastBytes = 4;    // values of an image of bytes that is examined
constexpr double GreyCells = 0.5;  // share of cells of grey values that are neither 0 nor 255

/// Counts the cells of each material above 0, then its busy cells.
std::vector<Index> CountCells(const CartesianGrid& grid, const FractionField& field)
{
  const int count = field.NumberOfMaterials();
  std::vector<Index> cells(2 * static_cast<std::size_t>(count) + 2, 0);
  const IndexBox& global = grid.Global();
  ForCells(grid.Owned(),
    [&](const Index3& cell)
    {
      const Index here = grid.Linear(cell);
      const int label = field.IsMixed(here) ? 0 : field.Label(here);
      if (label == 0)
      {
        return;
      }
      bool isBusy = false;
      for (int a = 0; a < 3; ++a)
      {
        Index3 next = cell;
        ++next[a];
        const Index there = next[a] < global.Upper[a] ? grid.Linear(next) : here;
        const int other = field.IsMixed(there) ? 0 : field.Label(there);
        isBusy = isBusy || (other != label && other != 0);
      }
      ++cells[2 * label];
      cells[2 * label + 1] += isBusy;
    });
  return cells;
}

/// Returns the begin of a sentence on some of all cells.
std::string Describe(Index values, Index some, Index all)
{
  char share[32];
  std::snprintf(
    share, sizeof(share), "%.3g", 100.0 * static_cast<double>(some) / static_cast<double>(all));
  return std::to_string(values) + " different values, and " + share + " % of the cells ";
}

/// Returns a description of labels that look like grey values, otherwise "".
/// Collective.
std::string DescribeGreyLabels(const LevelFields& fields, Ranks& ranks)
{
  const int labels = fields.Field.Fractions.NumberOfMaterials();
  if (labels < LeastLabels)
  {
    return "";
  }
  std::vector<Index> cells;
  WorkTogether(ranks, [&] { cells = CountCells(fields.Grid, fields.Field.Fractions); });
  ranks.Sum(cells);
  Index thin = 0, all = 0, busy = 0;
  for (int label = 1; label <= labels; ++label)
  {
    const Index own = cells[2 * label], ofOwn = cells[2 * label + 1];
    thin += own > 0 && static_cast<double>(ofOwn) >= ThinLabel * static_cast<double>(own);
    all += own;
    busy += ofOwn;
  }
  if (static_cast<double>(thin) < ThinLabels * labels ||
    static_cast<double>(busy) < BusyCells * static_cast<double>(all))
  {
    return "";
  }
  return Describe(labels, busy, all) + "have another value beside them";
}

/// Returns a description of a material that looks like grey values or labels, otherwise "".
/// Collective.
std::string DescribeGreyFractions(const LevelFields& fields, Ranks& ranks)
{
  constexpr Index Values = 256;
  const FractionField& field = fields.Field.Fractions;
  std::vector<Index> cells(Values + 1, 0); // of each value in mixed cells; then all
  ForCells(fields.Grid.Owned(),
    [&](const Index3& cell)
    {
      const Index here = fields.Grid.Linear(cell);
      ++cells[Values];
      if (field.IsMixed(here))
      {
        ++cells[std::lround((Values - 1) * field.Fraction(here, 1))];
      }
    });
  ranks.Sum(cells);
  const Index all = cells[Values];
  cells.pop_back();
  const Index values = Values - std::count(cells.begin(), cells.end(), 0);
  const Index grey = std::accumulate(cells.begin(), cells.end(), Index(0));
  if (values < LeastBytes || !(static_cast<double>(grey) > GreyCells * static_cast<double>(all)))
  {
    return "";
  }
  return Describe(values, grey, all) + "are neither 0 nor 255";
}

/// Returns whether the array is of bytes on all ranks.
/// Collective.
bool AreBytes(const std::string& name, const InputLevels& input, Ranks& ranks)
{
  bool areBytes = true;
  for (const InputBlocks& level : input.Levels)
  {
    for (const InputBlock& block : level.Blocks)
    {
      areBytes = areBytes && FindMaterialArray(block, name)->Type == ValueType::UnsignedChar;
    }
  }
  return !ranks.Any(!areBytes);
}

/// Returns a warning of an array; throws InputError if the user did not select it.
/// what: what it looks like; more: another possibility
std::string WarnOfGrey(const ArrayChoice& choice, const std::string& what, const std::string& found,
  const std::string& more)
{
  if (found.empty())
  {
    return "";
  }
  const std::string text = "The array '" + choice.Name + "' " + what + ": " + found +
    ". Threshold (--threshold LOW:HIGH) makes materials of ranges of values.";
  if (choice.IsGuessed)
  {
    throw InputError(text + " If each value is a material, choose the array as labels (" +
      choice.LabelsOption + " " + choice.Name + ")" + more + ".");
  }
  return text;
}

} // namespace

std::string CheckGreyLabels(const LevelFields& fields, const ArrayChoice& choice, Ranks& ranks)
{
  return WarnOfGrey(
    choice, "looks like grey values, not labels", DescribeGreyLabels(fields, ranks), "");
}

std::string CheckGreyFractions(
  const LevelFields& fields, const ArrayChoice& choice, const InputLevels& input, Ranks& ranks)
{
  const bool mayBeGrey = !IsFractionName(choice.Name) && AreBytes(choice.Name, input, ranks);
  return WarnOfGrey(choice, "looks like grey values or labels, not volume fractions of 255",
    mayBeGrey ? DescribeGreyFractions(fields, ranks) : "",
    "; if they are volume fractions, choose it as fractions (--fractions " + choice.Name + ")");
}

} // namespace vfm
