#include "GridFiles/VtkExtents.h"

#include "Base/ParseText.h"
#include "Ranks/Errors.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace vfm
{
namespace
{

constexpr double MostPoints = 1125899906842624.0; // 2^50

[[noreturn]] void RejectInts(const OutlineElement& element, const std::string& name, const char* as)
{
  RejectVtkFile("its " + element.Name + " has " + name + "=\"" + element.Get(name) +
    "\", which is not " + as + " in the allowed range");
}

/// Checks an attribute of some numbers, if the element has it.
void CheckNumbers(const OutlineElement& element, const std::string& name, int count)
{
  constexpr double largest = std::numeric_limits<double>::max();
  std::istringstream words(element.Get(name));
  int found = 0;
  for (std::string word; words >> word; ++found)
  {
    if (!ParseNumber(word, -largest, largest))
    {
      break;
    }
  }
  if (element.Attributes.count(name) > 0 && found != count)
  {
    RejectVtkFile("its " + element.Name + " has " + name + "=\"" + element.Get(name) + "\"; " +
      std::to_string(count) + " numbers are required");
  }
}

bool IsInside(const VtkExtent& piece, const VtkExtent& whole)
{
  bool isInside = true;
  for (int a = 0; a < 3; ++a)
  {
    isInside = isInside && piece[2 * a] >= whole[2 * a] && piece[2 * a + 1] <= whole[2 * a + 1];
  }
  return isInside;
}

} // namespace

void RejectVtkFile(const std::string& problem)
{
  throw InputError("the file is truncated or damaged: " + problem + ".");
}

template <std::size_t Count>
std::array<std::int64_t, Count> ReadVtkInts(
  const OutlineElement& element, const std::string& name, int least)
{
  std::istringstream words(element.Get(name));
  std::array<std::int64_t, Count> numbers{};
  for (std::int64_t& number : numbers)
  {
    std::string word;
    words >> word;
    const auto parsed = ParseCount(word, least, LargestVtkInt);
    if (!parsed)
    {
      RejectInts(element, name, Count == 1 ? "an integer" : "six integers");
    }
    number = *parsed;
  }
  return numbers;
}

template std::array<std::int64_t, 1> ReadVtkInts<1>(const OutlineElement&, const std::string&, int);
template std::array<std::int64_t, 6> ReadVtkInts<6>(const OutlineElement&, const std::string&, int);

VtkExtent ReadVtkExtent(const OutlineElement& element, const std::string& name)
{
  const VtkExtent extent = ReadVtkInts<6>(element, name, -LargestVtkInt);
  double points = 1.0;
  for (int a = 0; a < 3; ++a)
  {
    points *= static_cast<double>(std::max<std::int64_t>(extent[2 * a + 1] - extent[2 * a] + 1, 0));
  }
  if (points > MostPoints)
  {
    RejectVtkFile("its " + name + "=\"" + element.Get(name) + "\" has too many points");
  }
  return extent;
}

VtkPieceSize SizeOfVtkExtent(const VtkExtent& extent)
{
  VtkPieceSize size{ 1, 1, {} };
  for (int a = 0; a < 3; ++a)
  {
    size.Nodes[a] = std::max<std::int64_t>(extent[2 * a + 1] - extent[2 * a] + 1, 0);
    *size.Points *= size.Nodes[a];
  }
  for (std::int64_t nodes : size.Nodes)
  {
    *size.Cells *= *size.Points == 0 ? 0 : std::max<std::int64_t>(nodes - 1, 1);
  }
  return size;
}

void CheckVtkExtents(const OutlineElement& grid, const OutlineElement* part)
{
  const VtkExtent whole = ReadVtkExtent(grid, "WholeExtent");
  const std::int64_t required = *SizeOfVtkExtent(whole).Cells;
  if (part && !IsInside(ReadVtkExtent(*part, "Extent"), whole))
  {
    RejectVtkFile(
      "its extent is " + grid.Get("WholeExtent") + ", without its part " + part->Get("Extent"));
  }
  double found = 0.0;
  for (const OutlineElement& piece : grid.Children)
  {
    if (piece.Name != "Piece")
    {
      continue;
    }
    const VtkExtent extent = ReadVtkExtent(piece, "Extent");
    const std::int64_t cells = *SizeOfVtkExtent(extent).Cells;
    if (cells > 0 && !IsInside(extent, whole) && !part)
    {
      RejectVtkFile("its piece with the extent " + piece.Get("Extent") + " is not inside " +
        grid.Get("WholeExtent"));
    }
    found += static_cast<double>(cells);
  }
  if (found < static_cast<double>(required) && !part)
  {
    RejectVtkFile("its pieces hold fewer cells than its WholeExtent, " + std::to_string(required));
  }
  CheckNumbers(grid, "Origin", 3);
  CheckNumbers(grid, "Spacing", 3);
  CheckNumbers(grid, "Direction", 9);
}

} // namespace vfm
