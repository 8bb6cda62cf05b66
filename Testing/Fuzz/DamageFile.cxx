#include "DamageFile.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace vfm
{
namespace testing
{
namespace
{

/// Returns a position, often near the beginning, where headers are.
std::size_t DrawPosition(const std::string& bytes, RandomDraw& draw)
{
  const std::size_t size = bytes.size();
  const std::size_t reach = draw.Chance(0.5) ? std::min<std::size_t>(size, 600) : size;
  return reach == 0 ? 0 : draw.Seed() % reach;
}

std::size_t DrawLength(RandomDraw& draw)
{
  return static_cast<std::size_t>(draw.Scale(1.0, 300.0));
}

std::string DrawBytes(std::size_t count, RandomDraw& draw)
{
  std::string bytes(count, '\0');
  const bool isZero = draw.Chance(0.3);
  for (char& byte : bytes)
  {
    byte = isZero ? '\0' : static_cast<char>(draw.Seed());
  }
  return bytes;
}

template <class T>
std::string ToBytes(T value, bool isBigEndian)
{
  std::string bytes(sizeof value, '\0');
  std::memcpy(&bytes[0], &value, sizeof value);
  if (isBigEndian)
  {
    std::reverse(bytes.begin(), bytes.end());
  }
  return bytes;
}

/// Returns an unusual binary number as in headers.
std::string DrawBinaryNumber(RandomDraw& draw)
{
  const bool isBigEndian = draw.Chance(0.6);
  switch (draw.Whole(0, 2))
  {
    case 0:
      return ToBytes(draw.Pick<std::int32_t>({ 0, 1, -1, 7, 255, 65536, 1 << 20, 1 << 28, 1 << 30,
                       2147483647, -2147483647 }),
        isBigEndian);
    case 1:
      return ToBytes(draw.Pick<std::int64_t>({ 0, -1, 1LL << 20, 1LL << 31, 1LL << 40, 1LL << 62 }),
        isBigEndian);
    default:
      return ToBytes(
        draw.Pick<double>({ 0.0, -1.0, 1e9, 1e18, 1e300, -1e300, NAN, INFINITY, 1e-300 }),
        isBigEndian);
  }
}

/// Returns an unusual number as text.
std::string DrawTextNumber(RandomDraw& draw)
{
  return draw.Pick<const char*>(
    { "0", "-1", "1", "3", "65536", "1000000", "2147483647", "4294967296", "9223372036854775807",
      "99999999999999999999", "1e30", "nan", "inf", "0.5", "x", "", " " });
}

/// Replaces a run of digits at or after a position.
bool ReplaceDigits(std::string& bytes, std::size_t at, RandomDraw& draw)
{
  const auto isDigit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
  const auto first = std::find_if(bytes.begin() + at, bytes.end(), isDigit);
  if (first == bytes.end())
  {
    return false;
  }
  const auto last = std::find_if_not(first, bytes.end(), isDigit);
  bytes.replace(first, last, DrawTextNumber(draw));
  return true;
}

std::string DamageOnce(std::string& bytes, RandomDraw& draw)
{
  const std::size_t at = DrawPosition(bytes, draw), length = DrawLength(draw);
  const std::string place = " at " + std::to_string(at);
  switch (draw.Whole(0, 7))
  {
    case 0:
      bytes.resize(at);
      return "cut" + place;
    case 1:
      bytes.erase(at, length);
      return std::to_string(length) + " bytes taken out" + place;
    case 2:
      bytes.insert(at, DrawBytes(length, draw));
      return std::to_string(length) + " bytes put in" + place;
    case 3:
      bytes += DrawBytes(length, draw);
      return std::to_string(length) + " bytes at the end";
    case 4:
      bytes.insert(at, bytes.substr(at, length));
      return std::to_string(length) + " bytes repeated" + place;
    case 5:
    {
      const std::string number = DrawBinaryNumber(draw);
      const std::size_t aligned = at / 4 * 4;
      bytes.replace(aligned, number.size(), number);
      return "number of " + std::to_string(number.size()) + " bytes at " + std::to_string(aligned);
    }
    case 6:
      if (ReplaceDigits(bytes, at, draw))
      {
        return "digits after " + std::to_string(at);
      }
      [[fallthrough]];
    default:
      if (!bytes.empty())
      {
        bytes[at] = static_cast<char>(bytes[at] ^ (1 << draw.Whole(0, 7)));
      }
      return "bit flipped" + place;
  }
}

} // namespace

std::string DamageBytes(std::string& bytes, RandomDraw& draw)
{
  std::string done;
  for (int count = draw.Chance(0.6) ? 1 : draw.Whole(2, 4); count > 0; --count)
  {
    done += (done.empty() ? "" : ", ") + DamageOnce(bytes, draw);
  }
  return done;
}

} // namespace testing
} // namespace vfm
