#include "Images/ReadNumbers.h"

#include "Base/ParseText.h"
#include "Images/HeaderNumbers.h"
#include "OpenFile.h"

#include <charconv>
#include <cmath>
#include <iomanip>
#include <limits>
#include <type_traits>

namespace vfm
{
namespace
{

constexpr int LongestNumber = 64; // characters

/// Returns the value of a word; nothing if the type does not have it.
template <class Value>
std::optional<Value> ParseValue(const std::string& word)
{
  Value value{};
  const char* end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if (error == std::errc() && stop == end)
  {
    return value;
  }
  if constexpr (std::is_integral_v<Value>)
  {
    const std::optional<Index> integer = ParseInteger(word); // 2.0, 1e6, +5
    const bool isLarge = integer && *integer > 0 &&
      static_cast<std::uint64_t>(*integer) > std::uint64_t(std::numeric_limits<Value>::max());
    const bool isSmall = integer && *integer < 0 &&
      (std::is_unsigned_v<Value> || *integer < Index(std::numeric_limits<Value>::min()));
    return integer && !isLarge && !isSmall ? std::optional<Value>(static_cast<Value>(*integer))
                                           : std::nullopt;
  }
  const std::optional<double> real = ParseReal(word);
  const bool isInRange = real && std::abs(*real) <= double(std::numeric_limits<Value>::max());
  return isInRange ? std::optional<Value>(static_cast<Value>(*real)) : std::nullopt;
}

template <class Value>
void ReadAll(std::istream& stream, Value* values, Index count)
{
  for (Index i = 0; i < count; ++i)
  {
    std::string word;
    if (!(stream >> std::setw(LongestNumber) >> word))
    {
      throw InputError("its values are truncated: they are " + std::to_string(count) +
        " numbers, but there are " + std::to_string(i) + ".");
    }
    const std::optional<Value> value = ParseValue<Value>(word);
    if (!value)
    {
      constexpr bool isReal = std::is_floating_point_v<Value>;
      throw InputError("value " + std::to_string(i + 1) + " is '" + word + "', where " +
        (isReal ? std::string("a number is required.")
                : "an integer from " + std::to_string(std::numeric_limits<Value>::min()) + " to " +
              std::to_string(std::numeric_limits<Value>::max()) + " is required."));
    }
    values[i] = *value;
  }
}

} // namespace

TypedValues ReadNumbers(const StoredValues& stored, Index count)
{
  TypedValues values = MakeValues("", stored.Type, count);
  std::ifstream stream = OpenFile(stored.Files[0]);
  stream.seekg(stored.Begin);
  VisitType(stored.Type,
    [&](auto tag)
    {
      using Value = typename decltype(tag)::Type;
      ReadAll(stream, reinterpret_cast<Value*>(values.Bytes.data()), count);
    });
  return values;
}

} // namespace vfm
