#include "Options/MaterialWidths.h"

#include "Ranks/Errors.h"

namespace vfm
{
namespace
{

constexpr double NoWidth = std::numeric_limits<double>::infinity();

std::optional<double> ParseWidth(const std::string& text)
{
  const auto width = ParseNumber(TrimText(text), 0.0, std::numeric_limits<double>::max());
  return width && *width > 0.0 ? width : std::nullopt;
}

/// Parses the part after "small=".
std::optional<MaterialWidths::Small> ParseSmall(const std::string& text)
{
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos)
  {
    return std::nullopt;
  }
  const auto cells =
    ParseCount(TrimText(text.substr(0, colon)), 1, std::numeric_limits<int>::max());
  const auto width = ParseWidth(text.substr(colon + 1));
  return cells && width ? std::optional<MaterialWidths::Small>({ *cells, *width }) : std::nullopt;
}

/// Adds an entry. Returns whether its form is allowed.
bool AddEntry(const std::string& text, MaterialWidths& widths)
{
  const std::size_t equals = text.rfind('=');
  if (equals == std::string::npos)
  {
    return false;
  }
  const std::string name = TrimText(text.substr(0, equals)), value = text.substr(equals + 1);
  if (IsSameWord(name, "small") && value.find(':') != std::string::npos)
  {
    const auto small = ParseSmall(value);
    if (small)
    {
      widths.OfSmall.push_back(*small);
    }
    return small.has_value();
  }
  const auto width = ParseWidth(value);
  widths.Named.emplace_back(name, width.value_or(0.0));
  return width && !name.empty();
}

} // namespace

std::optional<MaterialWidths> ParseMaterialWidths(const std::string& text)
{
  MaterialWidths widths;
  widths.IsAutomatic = IsSameWord(TrimText(text), "auto");
  if (widths.IsAutomatic || TrimText(text).empty())
  {
    return widths;
  }
  for (const std::string& part : SplitText(text))
  {
    if (!AddEntry(part, widths))
    {
      return std::nullopt;
    }
  }
  return widths;
}

bool HasMaterialWidths(const MesherOptions& options)
{
  return ParseMaterialWidths(options.MaterialWidths).value_or(MaterialWidths()).IsUsed();
}

std::vector<double> FindWidths(const MaterialWidths& widths, const NamesById& names,
  const std::vector<int>& ids, const std::vector<Index>& cells)
{
  std::map<int, double> ofId;
  for (const auto& [text, width] : widths.Named)
  {
    const std::optional<int> id = FindMaterial(text, names);
    if (!id)
    {
      throw InputError("MaterialWidths contains '" + text +
        "', which is not a material. The materials are: " + ListMaterials(names) + ".");
    }
    const auto [place, isNew] = ofId.try_emplace(*id, width);
    place->second = std::min(place->second, width);
  }
  std::vector<double> result;
  for (std::size_t m = 0; m < ids.size(); ++m)
  {
    const auto own = ofId.find(ids[m]);
    double width = own == ofId.end() ? NoWidth : own->second;
    for (const MaterialWidths::Small& small : widths.OfSmall)
    {
      width = m > 0 && cells[m] < small.Cells ? std::min(width, small.Width) : width;
    }
    result.push_back(width);
  }
  return result;
}

} // namespace vfm
