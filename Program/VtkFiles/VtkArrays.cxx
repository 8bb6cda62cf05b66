#include "VtkFiles/VtkArrays.h"

#include "Base/ParseText.h"
#include "Ranks/Errors.h"

#include <algorithm>
#include <fstream>
#include <map>
#include <vector>

namespace vfm
{
namespace
{

constexpr std::int64_t MostValues = std::int64_t(1) << 50; // in an array
constexpr int MostComponents = 1 << 20;

/// Bytes of an array as they are stored: a part of the file, or a text in base64.
struct StoredArray
{
  std::vector<unsigned char> Head; // first bytes
  std::int64_t Length;             // bytes that follow in the file, with the head
};

[[noreturn]] void Reject(const OutlineElement& array, const std::string& what)
{
  throw InputError(
    "the file is truncated or damaged: its array '" + array.Get("Name") + "' " + what + ".");
}

/// Returns the bits of a value; nothing for unknown types.
std::optional<int> FindBits(const std::string& type)
{
  static const std::map<std::string, int> bits{ { "Bit", 1 }, { "Int8", 8 }, { "UInt8", 8 },
    { "Int16", 16 }, { "UInt16", 16 }, { "Int32", 32 }, { "UInt32", 32 }, { "Int64", 64 },
    { "UInt64", 64 }, { "Float32", 32 }, { "Float64", 64 } };
  const auto found = bits.find(type);
  return found == bits.end() ? std::nullopt : std::optional<int>(found->second);
}

int DigitOf(char c)
{
  static const std::string digits =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const std::size_t digit = digits.find(c);
  return digit == std::string::npos ? -1 : static_cast<int>(digit);
}

/// Decodes base64 up to its end or the first invalid sign.
std::vector<unsigned char> Decode(const std::string& text)
{
  std::vector<unsigned char> bytes;
  unsigned int bits = 0;
  int count = 0;
  for (char c : text)
  {
    const int digit = DigitOf(c);
    if (digit < 0)
    {
      break;
    }
    bits = (bits << 6 | static_cast<unsigned int>(digit)) & 0xffffffu;
    count += 6;
    if (count >= 8)
    {
      count -= 8;
      bytes.push_back(static_cast<unsigned char>(bits >> count));
    }
  }
  return bytes;
}

std::string ReadText(const VtkStorage& storage, std::int64_t place, std::size_t length)
{
  std::string text(length, '\0');
  std::ifstream stream(storage.Path, std::ios::binary);
  stream.seekg(place);
  stream.read(&text[0], static_cast<std::streamsize>(length));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return text;
}

StoredArray OpenArray(const OutlineElement& array, const VtkStorage& storage)
{
  constexpr std::size_t headLength = 64;
  if (array.Attributes.count("offset") == 0)
  {
    return { Decode(array.Head), array.Letters / 4 * 3 };
  }
  const auto offset =
    ParseNumber(array.Get("offset"), 0.0, static_cast<double>(storage.FileSize - storage.Begin));
  if (!offset || storage.Encoding.empty())
  {
    Reject(array, "begins at offset " + array.Get("offset") + " of the appended data, outside");
  }
  const std::int64_t place = storage.Begin + static_cast<std::int64_t>(*offset);
  const std::string text = ReadText(storage, place, headLength);
  if (storage.Encoding == "base64")
  {
    return { Decode(text), (storage.FileSize - place) / 4 * 3 };
  }
  return { { text.begin(), text.end() }, storage.FileSize - place };
}

/// Returns a number of the header of an array.
std::int64_t ReadNumber(
  const OutlineElement& array, const StoredArray& stored, int number, const VtkStorage& storage)
{
  const std::size_t size = storage.HeaderSize, first = number * size;
  if (stored.Head.size() < first + size)
  {
    Reject(array, "has no length");
  }
  std::uint64_t value = 0;
  for (std::size_t b = 0; b < size; ++b)
  {
    value = value << 8 | stored.Head[first + (storage.IsBigEndian ? b : size - 1 - b)];
  }
  if (value > static_cast<std::uint64_t>(MostValues))
  {
    Reject(array, "has a length of " + std::to_string(value) + " bytes");
  }
  return static_cast<std::int64_t>(value);
}

/// Returns the bytes of the values of compressed arrays: a number of blocks, their size, the size
/// of the last one if it is smaller, and the compressed size of each.
std::int64_t FindUnpackedSize(
  const OutlineElement& array, const StoredArray& stored, const VtkStorage& storage)
{
  const std::int64_t blocks = ReadNumber(array, stored, 0, storage);
  if (blocks == 0)
  {
    return 0;
  }
  const std::int64_t size = ReadNumber(array, stored, 1, storage),
                     last = ReadNumber(array, stored, 2, storage);
  if (blocks > stored.Length / storage.HeaderSize || last > size)
  {
    Reject(array, "has a header that contradicts itself");
  }
  const double bytes = static_cast<double>(blocks - 1) * static_cast<double>(size) +
    static_cast<double>(last > 0 ? last : size);
  if (bytes > storage.LargestRatio * static_cast<double>(stored.Length))
  {
    Reject(array, "has more values than its compressed data can contain");
  }
  return static_cast<std::int64_t>(bytes);
}

/// Checks the number of values that an array holds.
void CheckCount(const OutlineElement& array, std::optional<std::int64_t> values, int bits,
  const VtkStorage& storage)
{
  const auto tooFew = [&](std::int64_t found, const char* unit, std::int64_t required)
  {
    if (found < required)
    {
      Reject(array,
        "holds " + std::to_string(found) + " " + unit + ", " + std::to_string(required) +
          " are required");
    }
  };
  const std::int64_t required = (values.value_or(0) * bits + 7) / 8;
  const bool isText = array.Attributes.count("offset") == 0 && array.Get("format") != "binary";
  if (isText)
  {
    tooFew(array.Words, "values", bits == 1 ? required : values.value_or(0));
    return;
  }
  const StoredArray stored = OpenArray(array, storage);
  if (required == 0 && stored.Length == 0)
  {
    return;
  }
  const std::int64_t bytes = storage.IsPacked ? FindUnpackedSize(array, stored, storage)
                                              : ReadNumber(array, stored, 0, storage);
  tooFew(bytes, "bytes", required);
  if (!storage.IsPacked)
  {
    tooFew(stored.Length - storage.HeaderSize, "bytes", bytes);
  }
}

} // namespace

void CheckVtkArray(
  const OutlineElement& array, std::optional<std::int64_t> tuples, const VtkStorage& storage)
{
  const auto bits = FindBits(array.Get("type"));
  if (!bits)
  {
    Reject(array, "has the unknown type '" + array.Get("type") + "'");
  }
  const std::string count = array.Get("NumberOfComponents");
  const auto components = count.empty() ? 1 : ParseCount(count, 0, MostComponents);
  if (!components)
  {
    Reject(array, "has " + count + " components");
  }
  if (tuples && *tuples > MostValues / std::max(*components, 1))
  {
    Reject(array, "has too many values");
  }
  const auto values =
    tuples ? std::optional<std::int64_t>(*tuples * std::max(*components, 1)) : std::nullopt;
  CheckCount(array, values, *bits, storage);
}

} // namespace vfm
