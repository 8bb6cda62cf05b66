#include "GridFiles/VtkNumbers.h"

#include "Base/ParseText.h"
#include "Ranks/Errors.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>

namespace vfm
{
namespace
{

/// Calls function(Value()) with the C++ type of integers.
template <class Function>
auto VisitIntegers(const VtkType& type, Function function)
{
  const bool isSigned = type.Kind == VtkType::Signed;
  switch (type.Bytes)
  {
    case 1:
      return isSigned ? function(std::int8_t()) : function(std::uint8_t());
    case 2:
      return isSigned ? function(std::int16_t()) : function(std::uint16_t());
    case 4:
      return isSigned ? function(std::int32_t()) : function(std::uint32_t());
    default:
      return isSigned ? function(std::int64_t()) : function(std::uint64_t());
  }
}

template <class Value>
std::optional<double> ParseInteger(const char* begin, const char* end)
{
  Value value{};
  const auto parsed = std::from_chars(begin, end, value);
  return parsed.ec == std::errc() && parsed.ptr == end
    ? std::optional<double>(static_cast<double>(value))
    : std::nullopt;
}

/// Returns whether a word is nan or inf, with any case and sign.
bool IsSpecial(const std::string& word)
{
  const std::string name = word.substr(word[0] == '-' || word[0] == '+');
  return IsSameWord(name, "nan") || IsSameWord(name, "inf");
}

std::optional<double> ParseVtkReal(const std::string& word, const VtkType& type)
{
  if (word.find_first_not_of("0123456789+-.eE") != std::string::npos)
  {
    const bool isAllowed = !type.IsFinite && IsSpecial(word);
    return isAllowed ? std::optional<double>(std::nan("")) : std::nullopt;
  }
  const std::optional<double> value = ParseReal(word);
  const double most = type.Bytes == 4 ? double(std::numeric_limits<float>::max())
                                      : std::numeric_limits<double>::max();
  return value && std::abs(*value) <= most ? value : std::nullopt;
}

std::string DescribeRange(const VtkType& type)
{
  if (type.Kind == VtkType::Bit)
  {
    return "0 or 1";
  }
  if (type.Kind == VtkType::Real)
  {
    return std::string(type.IsFinite ? "a finite number" : "a number") +
      (type.Bytes == 4 ? " of single precision" : "");
  }
  return VisitIntegers(type,
    [](auto zero)
    {
      using Limits = std::numeric_limits<decltype(zero)>;
      return "an integer from " + std::to_string(Limits::min()) + " to " +
        std::to_string(Limits::max());
    });
}

} // namespace

std::optional<double> ParseVtkNumber(const std::string& word, const VtkType& type)
{
  if (word.empty())
  {
    return std::nullopt;
  }
  if (type.Kind == VtkType::Real)
  {
    return ParseVtkReal(word, type);
  }
  const bool hasPlus = word[0] == '+' && word.compare(1, 1, "-") != 0;
  const char *begin = word.data() + hasPlus, *end = word.data() + word.size();
  if (type.Kind == VtkType::Bit)
  {
    const auto bit = ParseInteger<int>(begin, end);
    return bit && (*bit == 0.0 || *bit == 1.0) ? bit : std::nullopt;
  }
  return VisitIntegers(type, [&](auto zero) { return ParseInteger<decltype(zero)>(begin, end); });
}

double DecodeVtkNumber(const unsigned char* bytes, const VtkType& type, bool isBigEndian)
{
  std::uint64_t bits = 0;
  for (int b = 0; b < type.Bytes; ++b)
  {
    bits = bits << 8 | bytes[isBigEndian ? b : type.Bytes - 1 - b];
  }
  const auto convert = [&bits](auto value)
  {
    const auto half = static_cast<std::uint32_t>(bits);
    sizeof(value) == 4 ? std::memcpy(&value, &half, 4) : std::memcpy(&value, &bits, sizeof(value));
    return static_cast<double>(value);
  };
  if (type.Kind == VtkType::Real)
  {
    return type.Bytes == 4 ? convert(float()) : convert(double());
  }
  return VisitIntegers(
    type, [&bits](auto zero) { return static_cast<double>(static_cast<decltype(zero)>(bits)); });
}

void RejectVtkNumber(std::int64_t index, const std::string& word, const VtkType& type)
{
  throw InputError("has " + QuoteWord(word) + " as value " + std::to_string(index) + ", where " +
    DescribeRange(type) + " is required.");
}

std::string QuoteWord(std::string word)
{
  word = word.substr(0, 40);
  std::replace_if(
    word.begin(), word.end(), [](unsigned char c) { return c < 32 || c > 126; }, '?');
  return "'" + word + "'";
}

} // namespace vfm
