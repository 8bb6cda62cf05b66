#include "Levels/InputRequests.h"

#include "Input/InputArrays.h"
#include "Input/InputRoute.h"
#include "Input/NodeCoordinates.h"
#include "Ranks/Agreement.h"

#include <cmath>
#include <sstream>

namespace vfm
{
namespace
{

bool IsNumberOfHalvings(double value)
{
  return value >= 0.0 && value <= MaximumHalvings && value == std::floor(value);
}

[[noreturn]] void RejectBox(std::size_t number, const RefinementBox& box, const std::string& why)
{
  std::ostringstream text;
  text << "The refinement box " << number + 1 << " reaches from (" << box.Lower[0] << ", "
       << box.Lower[1] << ", " << box.Lower[2] << ") to (" << box.Upper[0] << ", " << box.Upper[1]
       << ", " << box.Upper[2] << ") and requests " << box.Halvings << " halvings: " << why << ".";
  throw InputError(text.str());
}

void CheckBoxes(const std::vector<RefinementBox>& boxes)
{
  for (std::size_t b = 0; b < boxes.size(); ++b)
  {
    for (int a = 0; a < 3; ++a)
    {
      if (!(boxes[b].Lower[a] <= boxes[b].Upper[a])) // nor NaN
      {
        RejectBox(
          b, boxes[b], std::string("along ") + AxisNames[a] + " it must not end before it begins");
      }
    }
    if (!IsNumberOfHalvings(boxes[b].Halvings))
    {
      RejectBox(
        b, boxes[b], "the number must be an integer from 0 to " + std::to_string(MaximumHalvings));
    }
  }
}

/// Transforms boxes to image axes (ImageFrame).
std::vector<RefinementBox> TurnBoxes(std::vector<RefinementBox> boxes, const ImageFrame& frame)
{
  if (boxes.empty() || frame.IsIdentity())
  {
    return boxes;
  }
  if (!frame.IsAligned())
  {
    throw InputError(
      "Refinement boxes have sides along x, y and z, but the image is rotated against these axes "
      "(direction matrix). Select the cells by a Refinement Array.");
  }
  for (RefinementBox& box : boxes)
  {
    const Vector3 a = frame.ToOwn(box.Lower), b = frame.ToOwn(box.Upper);
    for (int axis = 0; axis < 3; ++axis)
    {
      box.Lower[axis] = std::min(a[axis], b[axis]);
      box.Upper[axis] = std::max(a[axis], b[axis]);
    }
  }
  return boxes;
}

/// Returns the cells of a grid that a box overlaps.
IndexBox CellsIn(const std::array<std::vector<double>, 3>& coordinates, const RefinementBox& box)
{
  IndexBox cells;
  for (int a = 0; a < 3; ++a)
  {
    const std::vector<double>& x = coordinates[a];
    for (std::size_t i = 0; i + 1 < x.size(); ++i)
    {
      const double margin = MatchTolerance * (x[i + 1] - x[i]);
      cells.Lower[a] += x[i + 1] - margin < box.Lower[a];
      cells.Upper[a] += x[i] + margin <= box.Upper[a];
    }
    cells.Upper[a] = std::max(cells.Lower[a], cells.Upper[a]);
  }
  return cells;
}

/// Refinement array in a block.
struct RequestArray
{
  std::string Name;
  std::string Level; // level of the block, for messages
  std::shared_ptr<const BlockArray> Values{};
};

void CheckValue(const RequestArray& array, double value, const Index3& cell)
{
  if (!IsNumberOfHalvings(value))
  {
    std::ostringstream text;
    text << "The refinement array '" << array.Name << "' holds " << value << " in " << TextOf(cell)
         << array.Level
         << ": it must hold the number of halvings of each cell, an integer from 0 to "
         << MaximumHalvings << ".";
    throw InputError(text.str());
  }
}

/// Adds the requests of a row; consecutive cells with equal requests are one box.
/// @param row  halvings of each cell
void AddRow(const std::vector<Index>& row, const Index3& first, std::vector<ChosenBox>& chosen)
{
  const Index count = static_cast<Index>(row.size());
  for (Index i = 0, end = 0; i < count; i = end)
  {
    while (end < count && row[end] == row[i])
    {
      ++end;
    }
    if (row[i] > 0)
    {
      chosen.push_back({ { { { first[0] + i, first[1], first[2] } },
                           { { first[0] + end, first[1] + 1, first[2] + 1 } } },
        row[i] });
    }
  }
}

/// Returns the most halvings that boxes request in each of a row of cells.
std::vector<Index> ReadBoxes(const std::vector<ChosenBox>& boxes, const IndexBox& row)
{
  std::vector<Index> halvings(row.Size(0), 0);
  for (const ChosenBox& box : boxes)
  {
    const IndexBox cells = Intersect(box.Cells, row);
    for (Index i = cells.Lower[0]; cells.NumberOfCells() > 0 && i < cells.Upper[0]; ++i)
    {
      Index& most = halvings[i - row.Lower[0]];
      most = std::max(most, box.Halvings);
    }
  }
  return halvings;
}

/// Raises the halvings of a row of cells to what an array requests.
void ReadArray(const RequestArray& array, const InputBlock& block, const Index3& first,
  std::vector<Index>& halvings)
{
  const Index id = block.CellId(first), count = static_cast<Index>(halvings.size());
  for (Index i = 0; i < count; ++i)
  {
    if (!IsHidden(block, id + i))
    {
      const double value = array.Values->Get(id + i, 0);
      CheckValue(array, value, { { first[0] + i, first[1], first[2] } });
      halvings[i] = std::max(halvings[i], static_cast<Index>(value));
    }
  }
}

/// Adds the requests of a block.
/// @param places  refinement boxes on its level
void ReadBlock(const InputBlock& block, const std::vector<ChosenBox>& places,
  const RequestArray& array, std::vector<ChosenBox>& chosen)
{
  ForRows(block.Box,
    [&](Index j, Index k)
    {
      const Index3 first{ { block.Box.Lower[0], j, k } };
      std::vector<Index> halvings =
        ReadBoxes(places, { first, { { block.Box.Upper[0], j + 1, k + 1 } } });
      ClearHidden(block, block.CellId(first), static_cast<Index>(halvings.size()), halvings.data());
      if (array.Values)
      {
        ReadArray(array, block, first, halvings);
      }
      AddRow(halvings, first, chosen);
    });
}

/// Returns the requests on a level.
/// @param array  without values
/// @param[in,out] cellsOfBoxes  adds the number of cells of this rank that each box selects
std::vector<ChosenBox> ReadLevel(const InputBlocks& blocks, const std::vector<RefinementBox>& boxes,
  RequestArray array, std::vector<Index>& cellsOfBoxes)
{
  std::vector<ChosenBox> places, chosen;
  for (const RefinementBox& box : boxes)
  {
    places.push_back({ CellsIn(blocks.Coordinates, box), static_cast<Index>(box.Halvings) });
  }
  for (const InputBlock& block : blocks.Blocks)
  {
    array.Values = array.Name.empty() ? nullptr : FindArray(block, array.Name);
    ReadBlock(block, places, array, chosen);
    for (std::size_t b = 0; b < boxes.size(); ++b)
    {
      cellsOfBoxes[b] += Intersect(places[b].Cells, block.Box).NumberOfCells();
    }
  }
  return chosen;
}

std::string WarnOfEmptyBoxes(const std::vector<Index>& cells)
{
  std::string text;
  for (std::size_t b = 0; b < cells.size(); ++b)
  {
    if (cells[b] == 0)
    {
      text += (text.empty() ? "No cell lies in the refinement box " : ", ") + std::to_string(b + 1);
    }
  }
  return text.empty() ? "" : text + ".";
}

} // namespace

InputRequests FindInputRequests(
  const InputLevels& input, const MesherOptions& options, Ranks& ranks)
{
  const std::string array = FindRefinementArray(options);
  const std::vector<RefinementBox> boxes = options.Refinement == RefinementMode::Automatic
    ? options.RefinementBoxes
    : std::vector<RefinementBox>();
  InputRequests requests;
  requests.Levels.resize(input.Levels.size());
  if (array.empty() && boxes.empty())
  {
    return requests;
  }
  CheckBoxes(boxes);
  const std::vector<RefinementBox> turned = TurnBoxes(boxes, input.Reading.Frame);
  std::vector<Index> counts(turned.size(), 0); // selected on this rank
  WorkTogether(ranks,
    [&]
    {
      for (int level = 0; level <= input.Finest(); ++level)
      {
        const std::string text = input.Finest() > 0 ? " of level " + std::to_string(level) : "";
        requests.Levels[level] = ReadLevel(input.Levels[level], turned, { array, text }, counts);
      }
    });
  Index cells = 0, finest = 0;
  for (int level = 0; level <= input.Finest(); ++level)
  {
    for (const ChosenBox& row : requests.Levels[level])
    {
      cells += row.Cells.NumberOfCells();
      finest = std::max(finest, level + row.Halvings);
    }
  }
  counts.push_back(cells);
  ranks.Sum(counts);
  requests.Cells = counts.back();
  counts.pop_back();
  requests.Warning = WarnOfEmptyBoxes(counts);
  requests.Finest = static_cast<int>(ranks.Max(static_cast<double>(finest)));
  return requests;
}

InputRequests DistributeRequests(const InputRequests& requests, const InputLevels& input,
  const std::vector<BlockPlace>& owners, Ranks& ranks)
{
  InputRequests shared = requests;
  for (int level = 0; requests.Cells > 0 && level <= input.Finest(); ++level)
  {
    const std::vector<BlockPlace> places = ChangeLevel(owners, level);
    const auto rowsIn = [&](const IndexBox& box)
    {
      std::vector<ChosenBox> rows;
      for (const ChosenBox& row : requests.Levels[level])
      {
        const IndexBox cells = Intersect(row.Cells, box);
        if (cells.NumberOfCells() > 0)
        {
          rows.push_back({ cells, row.Halvings });
        }
      }
      return rows;
    };
    const InputRoute route = FindInputRoute(places, input.Levels[level], ranks.Rank(), 0);
    std::vector<ChosenBox>& mine = shared.Levels[level];
    std::vector<std::vector<ChosenBox>> outgoing;
    WorkTogether(ranks,
      [&]
      {
        mine = rowsIn(BoxOfRank(places, ranks.Rank()));
        for (const IndexBox& requested : route.Requested)
        {
          outgoing.push_back(rowsIn(requested));
        }
      });
    const std::vector<ChosenBox> rows = ExchangeItems(ranks, route.Peers, outgoing);
    mine.insert(mine.end(), rows.begin(), rows.end());
  }
  return shared;
}

} // namespace vfm
