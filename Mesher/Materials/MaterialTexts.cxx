#include "Materials/MaterialTexts.h"

#include "Base/ParseText.h"

#include <cmath>
#include <iomanip>
#include <sstream>

namespace vfm
{

std::string NameMaterial(const Materials& table, std::size_t material)
{
  return "'" + table.Names[material] + "' (id " + std::to_string(table.Labels[material]) + ")";
}

std::string Enumerate(const std::vector<std::string>& items)
{
  constexpr std::size_t MaximumNames = 20;
  if (items.size() <= MaximumNames)
  {
    return JoinTexts(items);
  }
  return JoinTexts({ items.begin(), items.begin() + MaximumNames }) + " and " +
    std::to_string(items.size() - MaximumNames) + " more";
}

std::string CountMaterials(std::size_t count, const char* one, const char* several)
{
  return std::to_string(count) + (count == 1 ? " material " : " materials ") +
    (count == 1 ? one : several);
}

double RoundDown(double number)
{
  const double unit = std::pow(10.0, std::floor(std::log10(number)) - 2.0);
  return std::floor(number / unit) * unit;
}

std::string PercentOf(double share, bool showsPlus)
{
  const double percent = 100.0 * share;
  std::ostringstream text;
  text << (showsPlus ? std::showpos : std::noshowpos);
  if (std::fabs(percent) < 99.5)
  {
    text << std::setprecision(2);
  }
  else
  {
    text << std::fixed << std::setprecision(0);
  }
  text << percent << " %";
  return text.str();
}

} // namespace vfm
