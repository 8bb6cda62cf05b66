#include "Modify/MaterialPairs.h"

#include "Ranks/Errors.h"

namespace vfm
{
namespace
{

/// Returns the id of a material, `any` for \*, or nothing.
std::optional<int> FindMaterial(const std::string& text, const NamesById& names, int any)
{
  return text == "*" ? any : vfm::FindMaterial(text, names);
}

/// Parses a pair. A name may contain slashes itself.
std::optional<std::array<int, 2>> ParsePair(
  const std::string& text, const NamesById& names, int any)
{
  for (std::size_t at = text.find('/'); at != std::string::npos; at = text.find('/', at + 1))
  {
    const auto one = FindMaterial(TrimText(text.substr(0, at)), names, any);
    const auto other = FindMaterial(TrimText(text.substr(at + 1)), names, any);
    if (one && other && (*one != *other || *one == any))
    {
      return { { { *one, *other } } };
    }
  }
  return std::nullopt;
}

} // namespace

MaterialPairs::MaterialPairs(
  const std::string& option, const std::string& text, const NamesById& names)
{
  if (IsSameWord(text, "all"))
  {
    this->Pairs = { { { Any, Any } } };
    return;
  }
  for (const std::string& part : SplitText(text))
  {
    const std::optional<Pair> pair = ParsePair(part, names, Any);
    if (!pair)
    {
      throw InputError(option + " contains '" + part +
        "', which is not a pair of two different materials, such as steel/copper, 1/3 or steel/*. "
        "The materials are: " +
        ListMaterials(names) + ".");
    }
    this->Pairs.push_back(*pair);
  }
}

bool MaterialPairs::Contains(int one, int other) const
{
  return this->IsFirst(one, other) || this->IsFirst(other, one);
}

bool MaterialPairs::IsFirst(int first, int second) const
{
  const auto fits = [](int chosen, int material) { return chosen == Any || chosen == material; };
  return first != second &&
    std::any_of(this->Pairs.begin(), this->Pairs.end(),
      [&](const Pair& pair) { return fits(pair[0], first) && fits(pair[1], second); });
}

} // namespace vfm
