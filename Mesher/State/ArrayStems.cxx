#include "State/ArrayStems.h"

#include <algorithm>
#include <cctype>

namespace vfm
{
namespace
{

constexpr const char* Separators = " -_.:/";

enum class Kind
{
  Other,
  Letter,
  Digit
};

Kind KindOf(char c)
{
  const auto u = static_cast<unsigned char>(c);
  return std::isdigit(u) ? Kind::Digit : std::isalpha(u) || u > 127 ? Kind::Letter : Kind::Other;
}

/// Returns whether two adjacent characters belong to the same word or number.
bool IsInside(char left, char right)
{
  return KindOf(left) != Kind::Other && KindOf(left) == KindOf(right);
}

/// Returns the length of the common start of all names, without cutting a word or number.
std::size_t CommonStart(const std::vector<std::string>& names)
{
  std::size_t count = 0;
  const auto share = [&names](std::size_t n)
  {
    return std::all_of(names.begin(), names.end(),
      [&](const std::string& name) { return n < name.size() && name[n] == names[0][n]; });
  };
  while (share(count))
  {
    ++count;
  }
  const auto cuts = [&names](std::size_t n)
  {
    return std::any_of(names.begin(), names.end(),
      [n](const std::string& name) { return n == name.size() || IsInside(name[n - 1], name[n]); });
  };
  while (count > 0 && cuts(count))
  {
    --count;
  }
  return count;
}

/// Returns the part of each name that differs from the others.
std::vector<std::string> FindTokens(std::vector<std::string> names)
{
  for (int side = 0; side < 2; ++side) // remove the common start, then the common end
  {
    const std::size_t common = CommonStart(names);
    for (std::string& name : names)
    {
      name.erase(0, common);
      std::reverse(name.begin(), name.end());
    }
  }
  return names;
}

/// Returns whether a token in a name is a separate word. Digits at the end need no separator.
bool StandsAlone(const std::string& name, std::size_t at, const std::string& token)
{
  const std::size_t end = at + token.size();
  const bool isNumber =
    std::all_of(token.begin(), token.end(), [](char c) { return KindOf(c) == Kind::Digit; });
  const bool mayTouch = isNumber && end == name.size();
  const bool before = at == 0 || KindOf(token.front()) == Kind::Other ||
    (mayTouch ? !IsInside(name[at - 1], token.front()) : KindOf(name[at - 1]) == Kind::Other);
  const bool after =
    end == name.size() || KindOf(token.back()) == Kind::Other || KindOf(name[end]) == Kind::Other;
  return before && after;
}

/// Joins the parts of a name around a token, without separators at its ends or in a row.
std::string JoinStem(std::string before, const std::string& after)
{
  before.erase(before.find_last_not_of(Separators) + 1);
  const std::string name = before + after;
  const std::size_t first = name.find_first_not_of(Separators);
  return first == std::string::npos
    ? ""
    : name.substr(first, name.find_last_not_of(Separators) + 1 - first);
}

/// Adds the stems of a name in which a token is a separate word; tokens: its replacements in the
/// names of all members.
void AddStemsOf(const std::string& name, const std::string& token,
  const std::vector<std::string>& tokens, std::vector<ArrayStem>& stems)
{
  for (std::size_t at = name.find(token); !token.empty() && at != std::string::npos;
       at = name.find(token, at + 1))
  {
    const std::string before = name.substr(0, at), after = name.substr(at + token.size());
    ArrayStem stem{ JoinStem(before, after), {} };
    if (stem.Name.empty() || !StandsAlone(name, at, token))
    {
      continue;
    }
    for (const std::string& other : tokens)
    {
      stem.Members.push_back(before + other + after);
    }
    stems.push_back(std::move(stem));
  }
}

} // namespace

MaterialStems::MaterialStems(const std::vector<std::string>& names, const std::vector<int>& labels)
{
  if (names.size() < 3) // void and one
  {
    return;
  }
  this->Tokens = FindTokens({ names.begin() + 1, names.end() });
  for (std::size_t m = 1; m < labels.size(); ++m)
  {
    this->Numbers.push_back(" - " + std::to_string(labels[m]));
  }
}

std::vector<ArrayStem> MaterialStems::FindStems(const std::string& name) const
{
  std::vector<ArrayStem> stems;
  for (const std::vector<std::string>* tokens : { &this->Tokens, &this->Numbers })
  {
    for (const std::string& token : *tokens)
    {
      AddStemsOf(name, token, *tokens, stems);
    }
  }
  return stems;
}

std::optional<ArrayStem> FindVector(const std::string& component)
{
  std::vector<ArrayStem> stems;
  for (const std::vector<std::string>& axes :
    { std::vector<std::string>{ "x", "y", "z" }, { "X", "Y", "Z" } })
  {
    for (const std::string& axis : axes)
    {
      AddStemsOf(component, axis, axes, stems);
    }
  }
  return stems.empty() ? std::nullopt : std::make_optional(stems[0]);
}

bool IsOfVector(const std::string& name, const std::string& vector)
{
  const std::optional<ArrayStem> found = FindVector(name);
  const auto isNamed = [&vector](const std::string& member) { return member == vector; };
  return name == vector ||
    (found && !vector.empty() &&
      (found->Name == vector ||
        std::any_of(found->Members.begin(), found->Members.end(), isNamed)));
}

} // namespace vfm
