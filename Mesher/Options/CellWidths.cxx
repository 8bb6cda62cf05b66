#include "Options/CellWidths.h"

#include "Base/ParseText.h"

#include <limits>

namespace vfm
{

std::optional<Vector3> ParseWidths(const std::string& text)
{
  std::string list = TrimText(text);
  if (list.empty())
  {
    return Vector3{};
  }
  if (list.find(',') == std::string::npos)
  {
    std::replace(list.begin(), list.end(), ' ', ',');
  }
  std::vector<double> widths;
  for (const std::string& part : SplitText(list))
  {
    const auto width = ParseNumber(part, 0.0, std::numeric_limits<double>::max());
    if (!width)
    {
      return std::nullopt;
    }
    widths.push_back(*width);
  }
  if (widths.size() == 1)
  {
    widths.resize(3, widths[0]);
  }
  return widths.size() == 3 ? std::optional<Vector3>({ widths[0], widths[1], widths[2] })
                            : std::nullopt;
}

bool HasCellWidth(const MesherOptions& options)
{
  return ParseWidths(options.CellWidth).value_or(Vector3{}) != Vector3{};
}

} // namespace vfm
