#include "Base/ParseText.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <locale>
#include <sstream>

namespace vfm
{
namespace
{

constexpr const char* Spaces = " \t\r\n\v\f";

template <class Value>
std::optional<Value> Parse(const std::string& text, Value least, Value most)
{
  Value value{};
  const char* end = text.data() + text.size();
  const std::from_chars_result result = std::from_chars(text.data(), end, value);
  const bool isGood = result.ec == std::errc() && result.ptr == end;
  return isGood && value >= least && value <= most ? std::optional<Value>(value) : std::nullopt;
}

} // namespace

std::string ToLower(std::string text)
{
  for (char& c : text)
  {
    c = ToLower(c);
  }
  return text;
}

bool IsSameWord(const std::string& one, const std::string& other)
{
  std::size_t i = one.find_first_not_of(' '), j = other.find_first_not_of(' ');
  while (i != std::string::npos && j != std::string::npos && ToLower(one[i]) == ToLower(other[j]))
  {
    i = one.find_first_not_of(' ', i + 1);
    j = other.find_first_not_of(' ', j + 1);
  }
  return i == std::string::npos && j == std::string::npos;
}

std::optional<double> ParseNumber(const std::string& text, double least, double most)
{
  return Parse(text, least, most);
}

std::optional<int> ParseCount(const std::string& text, int least, int most)
{
  return Parse(text, least, most);
}

std::optional<double> ParseReal(const std::string& text)
{
  const bool hasPlus = text.size() > 1 && text[0] == '+' && text[1] != '-';
  const char *begin = text.data() + hasPlus, *end = text.data() + text.size();
  double value = 0.0;
  const auto [stop, error] = std::from_chars(begin, end, value);
  if (stop == end && error == std::errc::result_out_of_range)
  {
    std::istringstream stream(text); // distinguishes numbers that are too small
    stream.imbue(std::locale::classic());
    return stream >> value ? std::optional<double>(value) : std::nullopt;
  }
  const bool isGood = stop == end && error == std::errc() && std::isfinite(value);
  return isGood ? std::optional<double>(value) : std::nullopt;
}

std::optional<bool> ParseSwitch(const std::string& text)
{
  const std::vector<std::string> words{ "off", "on", "false", "true", "no", "yes", "0", "1" };
  for (std::size_t i = 0; i < words.size(); ++i)
  {
    if (IsSameWord(text, words[i]))
    {
      return i % 2 == 1;
    }
  }
  return std::nullopt;
}

std::optional<int> ParseChoice(const std::string& text, const std::vector<std::string>& words)
{
  for (std::size_t i = 0; i < words.size(); ++i)
  {
    if (IsSameWord(text, words[i]))
    {
      return static_cast<int>(i);
    }
  }
  return ParseCount(text, 0, static_cast<int>(words.size()) - 1);
}

namespace
{

template <class Real>
std::string Format(Real number)
{
  std::array<char, 32> text{};
  const std::to_chars_result made = std::to_chars(text.data(), text.data() + text.size(), number);
  std::string result(text.data(), made.ptr);
  const std::size_t exponent = result.find('e');
  if (exponent != std::string::npos) // 1e-06, 1e+06
  {
    const std::size_t digits = result.find_first_of("123456789", exponent);
    result = result.substr(0, exponent + 1) + (result[exponent + 1] == '-' ? "-" : "") +
      result.substr(digits);
  }
  return result;
}

} // namespace

std::string FormatNumber(double number)
{
  return Format(number);
}

std::string FormatNumber(float number)
{
  return Format(number);
}

std::string SnakeCase(const std::string& name)
{
  std::string snake;
  for (char c : name)
  {
    const bool isCapital = c >= 'A' && c <= 'Z';
    snake += isCapital && !snake.empty() ? "_" : "";
    snake += ToLower(c);
  }
  return snake;
}

std::string TrimText(const std::string& text)
{
  const std::size_t first = text.find_first_not_of(Spaces);
  return first == std::string::npos ? ""
                                    : text.substr(first, text.find_last_not_of(Spaces) - first + 1);
}

std::string JoinTexts(const std::vector<std::string>& texts, const std::string& separator)
{
  std::string joined;
  for (const std::string& text : texts)
  {
    joined += (joined.empty() ? "" : separator) + text;
  }
  return joined;
}

namespace
{

/// Returns the end of a quoted part that begins at a place, behind its second quote, if a comma or
/// the end of the text follows; otherwise npos.
std::size_t FindQuoteEnd(const std::string& text, std::size_t begin)
{
  const std::size_t first = text.find_first_not_of(Spaces, begin);
  if (first == std::string::npos || text[first] != '"')
  {
    return std::string::npos;
  }
  for (std::size_t end = text.find('"', first + 1); end != std::string::npos;
       end = text.find('"', end + 1))
  {
    const std::size_t next = text.find_first_not_of(Spaces, end + 1);
    if (next == std::string::npos || text[next] == ',')
    {
      return end + 1;
    }
  }
  return std::string::npos;
}

} // namespace

std::vector<std::string> SplitText(const std::string& text)
{
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= text.size();)
  {
    const std::size_t quote = FindQuoteEnd(text, begin);
    const bool isQuoted = quote != std::string::npos;
    const std::size_t end = std::min(text.find(',', isQuoted ? quote : begin), text.size());
    const std::string part = TrimText(text.substr(begin, end - begin));
    parts.push_back(isQuoted ? part.substr(1, part.size() - 2) : part);
    begin = end + 1;
  }
  return parts;
}

std::string QuoteName(const std::string& name)
{
  const bool isPlain = name.find(',') == std::string::npos && TrimText(name) == name;
  return isPlain ? name : "\"" + name + "\"";
}

} // namespace vfm
