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

/// State while requests are read, block by block.
struct Work
{
  const InputLevels& Input;
  const std::string& Array;
  const std::vector<RefinementBox> Boxes;
  std::vector<Index> CellsOfBoxes = std::vector<Index>(Boxes.size()); // selected on this rank
  std::vector<std::vector<ChosenBox>> Rows{};                         // selected, by level
  std::vector<ChosenBox> Places{};                                    // Boxes on the current level
  std::vector<Index> Row{};
};

void CheckValue(const Work& work, double value, const Index3& cell, int level)
{
  if (!IsNumberOfHalvings(value))
  {
    std::ostringstream text;
    text << "The refinement array '" << work.Array << "' holds " << value << " in " << TextOf(cell);
    text << (work.Input.Finest() > 0 ? " of level " + std::to_string(level) : "")
         << ": it must hold the number of halvings of each cell, an integer from 0 to "
         << MaximumHalvings << ".";
    throw InputError(text.str());
  }
}

/// Adds the cells of a row; consecutive cells with equal requests are one box.
void AddRow(Work& work, const Index3& first)
{
  const Index count = static_cast<Index>(work.Row.size());
  for (Index i = 0, end = 0; i < count; i = end)
  {
    while (end < count && work.Row[end] == work.Row[i])
    {
      ++end;
    }
    if (work.Row[i] > 0)
    {
      work.Rows.back().push_back({ { { { first[0] + i, first[1], first[2] } },
                                     { { first[0] + end, first[1] + 1, first[2] + 1 } } },
        work.Row[i] });
    }
  }
}

void ReadRow(
  Work& work, const InputBlock& block, const BlockArray* array, int level, Index j, Index k)
{
  const Index begin = block.Box.Lower[0], count = block.Box.Size(0);
  work.Row.assign(count, 0);
  for (const ChosenBox& place : work.Places)
  {
    const IndexBox cells =
      Intersect(place.Cells, { { { begin, j, k } }, { { begin + count, j + 1, k + 1 } } });
    for (Index i = cells.Lower[0]; cells.NumberOfCells() > 0 && i < cells.Upper[0]; ++i)
    {
      work.Row[i - begin] = std::max(work.Row[i - begin], place.Halvings);
    }
  }
  const Index id = block.CellId({ { begin, j, k } });
  ClearHidden(block, id, count, work.Row.data());
  for (Index i = 0; array && i < count; ++i)
  {
    if (!IsHidden(block, id + i))
    {
      const double value = array->Get(id + i, 0);
      CheckValue(work, value, { { begin + i, j, k } }, level);
      work.Row[i] = std::max(work.Row[i], static_cast<Index>(value));
    }
  }
  AddRow(work, { { begin, j, k } });
}

void ReadLevel(Work& work, int level)
{
  work.Rows.emplace_back();
  const InputBlocks& blocks = work.Input.Levels[level];
  work.Places.clear();
  for (const RefinementBox& box : work.Boxes)
  {
    work.Places.push_back({ CellsIn(blocks.Coordinates, box), static_cast<Index>(box.Halvings) });
  }
  for (const InputBlock& block : blocks.Blocks)
  {
    const auto array = work.Array.empty() ? nullptr : FindArray(block, work.Array);
    ForRows(block.Box, [&](Index j, Index k) { ReadRow(work, block, array.get(), level, j, k); });
    for (std::size_t b = 0; b < work.Boxes.size(); ++b)
    {
      work.CellsOfBoxes[b] += Intersect(work.Places[b].Cells, block.Box).NumberOfCells();
    }
  }
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

InputRequests FindInputRequests(const InputLevels& input, const std::string& array,
  const std::vector<RefinementBox>& boxes, Ranks& ranks)
{
  InputRequests requests;
  requests.Levels.resize(input.Levels.size());
  if (array.empty() && boxes.empty())
  {
    return requests;
  }
  CheckBoxes(boxes);
  Work work{ input, array, TurnBoxes(boxes, input.Reading.Frame) };
  WorkTogether(ranks,
    [&]
    {
      for (int level = 0; level <= input.Finest(); ++level)
      {
        ReadLevel(work, level);
      }
    });
  requests.Levels = std::move(work.Rows);
  Index cells = 0, finest = 0;
  for (int level = 0; level <= input.Finest(); ++level)
  {
    for (const ChosenBox& row : requests.Levels[level])
    {
      cells += row.Cells.NumberOfCells();
      finest = std::max(finest, level + row.Halvings);
    }
  }
  std::vector<Index> counts = std::move(work.CellsOfBoxes);
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
