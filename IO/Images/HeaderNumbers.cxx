#include "Images/HeaderNumbers.h"

#include "Base/ParseText.h"
#include "Ranks/Errors.h"

#include <cmath>

namespace vfm
{
namespace
{

template <class Value>
std::vector<Value> ParseAll(const std::string& field, const std::string& text, std::size_t count,
  std::optional<Value> (*parse)(const std::string&), const std::string& what)
{
  const std::vector<std::string> words = SplitWords(text);
  std::vector<Value> values;
  for (const std::string& word : words)
  {
    const std::optional<Value> value = parse(word);
    if (value)
    {
      values.push_back(*value);
    }
  }
  if (values.size() != count || words.size() != count)
  {
    throw InputError("its header says '" + field + ": " + text.substr(0, 80) + "', where " +
      std::to_string(count) + what + (count == 1 ? " is required." : "s are required."));
  }
  return values;
}

} // namespace

std::vector<std::string> SplitWords(const std::string& text)
{
  constexpr const char* blanks = " \t\r\n\v\f";
  std::vector<std::string> words;
  for (std::size_t begin = text.find_first_not_of(blanks); begin != std::string::npos;)
  {
    const std::size_t end = text.find_first_of(blanks, begin);
    words.push_back(text.substr(begin, end - begin));
    begin = text.find_first_not_of(blanks, end);
  }
  return words;
}

std::optional<Index> ParseInteger(const std::string& word)
{
  const std::optional<double> value = ParseReal(word);
  const bool isInteger = value && std::abs(*value) < 0x1p53 && *value == std::floor(*value);
  return isInteger ? std::optional<Index>(static_cast<Index>(*value)) : std::nullopt;
}

std::vector<double> ParseReals(const std::string& field, const std::string& text, std::size_t count)
{
  return ParseAll(field, text, count, ParseReal, " number");
}

std::vector<Index> ParseIntegers(
  const std::string& field, const std::string& text, std::size_t count)
{
  return ParseAll(field, text, count, ParseInteger, " integer");
}

} // namespace vfm
