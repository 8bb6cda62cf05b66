#include "GridFiles/StoredBytes.h"

#include "GridFiles/VtkNumbers.h"
#include "Ranks/Errors.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <vector>

namespace vfm
{
namespace
{

constexpr int NoLetter = -1;
constexpr int Padding = 64;

/// Returns the digit of each letter of base64; Padding for '='; NoLetter.
std::array<int, 256> MakeDigits()
{
  static const std::string letters =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/=";
  std::array<int, 256> digits{};
  digits.fill(NoLetter);
  for (std::size_t d = 0; d < letters.size(); ++d)
  {
    digits[static_cast<unsigned char>(letters[d])] = static_cast<int>(d);
  }
  return digits;
}

} // namespace

StoredBytes::StoredBytes(const VtkStorage& storage, std::int64_t place, bool isBase64) :
  Stream(storage.Open()), Size(storage.FileSize), IsBase64(isBase64)
{
  this->Stream->seekg(place);
  while (isBase64 && std::isspace(this->Stream->peek()))
  {
    this->Stream->get();
  }
}

/// Returns the next digit, or NoLetter at the end of the text.
int StoredBytes::Letter()
{
  static const std::array<int, 256> digits = MakeDigits();
  constexpr int end = std::istream::traits_type::eof();
  const int c = this->Stream->peek();
  if (c == end || c == '<')
  {
    return NoLetter;
  }
  if (digits[c] != NoLetter)
  {
    this->Stream->get();
    ++this->Letters;
    return digits[c];
  }
  while (std::isspace(this->Stream->peek()))
  {
    this->Stream->get();
  }
  const int next = this->Stream->peek();
  if (std::isspace(c) && (next == end || next == '<'))
  {
    return NoLetter;
  }
  throw InputError("holds " + QuoteWord(std::string(1, static_cast<char>(c))) + " after " +
    std::to_string(this->Letters) + " letters of base64.");
}

/// Decodes four letters to at most three bytes.
void StoredBytes::ReadGroup()
{
  unsigned int bits = 0;
  int letters = 0, paddings = 0;
  for (int l = 0; l < 4; ++l)
  {
    const int digit = this->Letter();
    if (digit == NoLetter)
    {
      break;
    }
    const bool isPadding = digit == Padding;
    if ((isPadding && l < 2) || (!isPadding && paddings > 0))
    {
      throw InputError("holds '=' before letter " + std::to_string(this->Letters) +
        " of base64, where the text does not end.");
    }
    paddings += isPadding;
    bits = bits << 6 | static_cast<unsigned int>(isPadding ? 0 : digit);
    ++letters;
  }
  this->Used = 0;
  this->Held = letters == 4 ? 3 - paddings : 0; // VTK reads whole groups
  for (int b = 0; b < 3; ++b)
  {
    this->Group[b] = static_cast<unsigned char>(bits >> (16 - 8 * b));
  }
}

std::size_t StoredBytes::Read(unsigned char* to, std::size_t count)
{
  if (!this->IsBase64)
  {
    this->Stream->read(reinterpret_cast<char*>(to), static_cast<std::streamsize>(count));
    return static_cast<std::size_t>(this->Stream->gcount());
  }
  for (std::size_t done = 0; done < count; ++done)
  {
    if (this->Used == this->Held)
    {
      const bool hasEnded = this->Held == 1 || this->Held == 2;
      if (!hasEnded)
      {
        this->ReadGroup();
      }
      if (hasEnded || this->Held == 0)
      {
        return done;
      }
    }
    to[done] = this->Group[this->Used++];
  }
  return count;
}

bool StoredBytes::Skip(std::int64_t count)
{
  if (!this->IsBase64)
  {
    const bool isThere = count <= this->CountLeft();
    this->Stream->seekg(count, std::ios::cur);
    return isThere;
  }
  std::vector<unsigned char> bytes(static_cast<std::size_t>(std::min<std::int64_t>(count, 4096)));
  while (count > 0)
  {
    const auto part = std::min<std::size_t>(bytes.size(), static_cast<std::size_t>(count));
    if (this->Read(bytes.data(), part) < part)
    {
      return false;
    }
    count -= static_cast<std::int64_t>(part);
  }
  return true;
}

std::int64_t StoredBytes::CountLeft()
{
  const std::int64_t place = this->Stream->tellg();
  const std::int64_t left = place < 0 ? 0 : std::max<std::int64_t>(this->Size - place, 0);
  return this->IsBase64 ? left / 4 * 3 + 3 : left;
}

void StoredBytes::CheckEnd()
{
  while (std::isspace(this->Stream->peek()))
  {
    this->Stream->get();
  }
  if (this->Stream->peek() != '<')
  {
    throw InputError("holds " + QuoteWord(std::string(1, static_cast<char>(this->Stream->peek()))) +
      " after its values, where it must end.");
  }
}

} // namespace vfm
