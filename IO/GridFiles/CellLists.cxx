#include "GridFiles/CellLists.h"

#include "Base/ParseText.h"
#include "GridFiles/VtkArrays.h"
#include "GridFiles/VtkExtents.h"
#include "Ranks/Errors.h"

#include <cmath>
#include <string_view>

namespace vfm
{
namespace
{

std::string Text(double value)
{
  constexpr double most = 9007199254740992.0; // 2^53
  return std::abs(value) <= most ? std::to_string(static_cast<std::int64_t>(value))
                                 : FormatNumber(value);
}

const OutlineElement& FindList(const OutlineElement& lists, std::string_view name)
{
  for (const OutlineElement& list : lists.Children)
  {
    if (list.Get("Name") == name)
    {
      return list;
    }
  }
  RejectVtkFile("its " + lists.Name + " have no array '" + std::string(name) + "'");
}

/// Checks a list whose values must be in a range.
/// @return number of values
std::int64_t CheckRange(const OutlineElement& list, std::optional<std::int64_t> count, double most,
  const VtkStorage& storage)
{
  std::int64_t found = 0;
  CheckVtkArray(list, count, storage,
    [&](double value)
    {
      ++found;
      if (!(value >= 0.0 && value <= most))
      {
        throw InputError("has " + Text(value) + " as value " + std::to_string(found) +
          ", where an integer from 0 to " + Text(most) + " is required.");
      }
    });
  return found;
}

/// Checks the ends of the lists of cells, which must not decrease.
/// @return the last one
double CheckEnds(const OutlineElement& list, std::int64_t cells, const VtkStorage& storage)
{
  double end = 0.0;
  std::int64_t found = 0;
  CheckVtkArray(list, cells, storage,
    [&](double value)
    {
      ++found;
      if (!(value >= end))
      {
        throw InputError("has " + Text(value) + " as value " + std::to_string(found) + " after " +
          Text(end) + "; values must not decrease.");
      }
      end = value;
    });
  return end;
}

} // namespace

void CheckCellLists(
  const OutlineElement& lists, std::int64_t cells, std::int64_t points, const VtkStorage& storage)
{
  if (cells == 0)
  {
    return;
  }
  const double end = CheckEnds(FindList(lists, "offsets"), cells, storage);
  const OutlineElement& corners = FindList(lists, "connectivity");
  const auto count = CheckRange(corners, std::nullopt, static_cast<double>(points) - 1.0, storage);
  if (end > static_cast<double>(count))
  {
    RejectVtkFile("its cells have " + Text(end) + " points, its array 'connectivity' holds " +
      std::to_string(count));
  }
  for (const OutlineElement& list : lists.Children)
  {
    const std::string name = list.Get("Name");
    if (name == "types")
    {
      CheckRange(list, cells, 255.0, storage);
    }
    else if (name != "offsets" && name != "connectivity")
    {
      CheckVtkArray(list, std::nullopt, storage);
    }
  }
}

} // namespace vfm
