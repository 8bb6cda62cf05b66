/**
 * What ends the work of a rank. Texts are kept in place, so that where memory has run out an error can still be thrown and told
 * to the other ranks.
 */
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <exception>
#include <limits>
#include <string>

namespace vfm
{

/// Why a rank failed, as it is sent.
struct Failure
{
  static constexpr std::size_t LongestText = 2032;

  std::int32_t Rank; ///< that failed, of those that the sender knows of
  std::int32_t Code; ///< of the error
  char Text[LongestText];

  Failure() noexcept : Failure(NoRank, 0, "") {}
  Failure(int rank, int code, const char* text) noexcept : Rank(rank), Code(code)
  {
    const std::size_t length = std::min(std::strlen(text), LongestText - 1);
    std::memcpy(this->Text, text, length);
    std::memset(this->Text + length, 0, LongestText - length);
  }
  /// Which of two all ranks tell: that of the lower rank.
  bool operator<(const Failure& other) const noexcept
  {
    if (this->Rank != other.Rank)
    {
      return this->Rank < other.Rank;
    }
    const int order = std::memcmp(this->Text, other.Text, LongestText);
    return order != 0 ? order < 0 : this->Code < other.Code;
  }

  static constexpr std::int32_t OutOfMemory = -1; ///< a code; others are of programs
  static constexpr std::int32_t NoRank = std::numeric_limits<std::int32_t>::max();
};

/// Of one rank of several, or alone.
inline Failure LackOfMemory(int rank, int count) noexcept
{
  char text[64] = "Not enough memory.";
  if (count > 1)
  {
    std::snprintf(text, sizeof(text), "Not enough memory on rank %d.", rank);
  }
  return { rank, Failure::OutOfMemory, text };
}

/// The input cannot be meshed; what() tells which array, which value, where, what to do. Texts beyond Failure::LongestText are cut.
class InputError : public std::exception
{
public:
  explicit InputError(const char* text, int code = 0) noexcept : What(0, code, text) {}
  explicit InputError(const std::string& text, int code = 0) noexcept :
    InputError(text.c_str(), code)
  {
  }
  const char* what() const noexcept override { return this->What.Text; }
  /// Failure::OutOfMemory, or of programs, which give it a meaning; told to other ranks with the text.
  int Code() const { return this->What.Code; }

private:
  Failure What;
};

/// An error of which all ranks know, and which all throw (WorkTogether).
class FailedTogether : public InputError
{
public:
  explicit FailedTogether(const Failure& failure) noexcept : InputError(failure.Text, failure.Code)
  {
  }
};

/// Thrown out of a stage when the user asked to stop.
struct Aborted : std::exception
{
  const char* what() const noexcept override { return "aborted"; }
};

} // namespace vfm
