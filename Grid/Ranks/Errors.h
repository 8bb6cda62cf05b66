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
#include <new>
#include <string>

namespace vfm
{

/// What failed. Programs and hosts report it by numbers of their own.
enum class ErrorCode : std::int32_t
{
  Unknown, ///< the caller knows (ClassifyErrors)
  WrongArguments,
  UnreadableInput,
  RejectedMesh, ///< input that cannot be meshed
  UnwritableOutput,
  InternalError,
  OutOfMemory,
  NoMesh,
  TooLarge,
  WrongHandle
};

/// Why a rank failed, as it is sent.
struct Failure
{
  static constexpr std::size_t LongestText = 2032;

  std::int32_t Rank; ///< that failed, of those that the sender knows of
  ErrorCode Code;
  char Text[LongestText];

  Failure() noexcept : Failure(NoRank, ErrorCode::Unknown, "") {}
  Failure(int rank, ErrorCode code, const char* text) noexcept : Rank(rank), Code(code)
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
  return { rank, ErrorCode::OutOfMemory, text };
}

/// The input cannot be meshed, or what the code says; what() tells which array, which value, where, what to do. Texts beyond
/// Failure::LongestText are cut.
class InputError : public std::exception
{
public:
  explicit InputError(const Failure& failure) noexcept : What(failure) {}
  InputError(ErrorCode code, const std::string& text) noexcept : What(0, code, text.c_str()) {}
  explicit InputError(const char* text) noexcept : What(0, ErrorCode::Unknown, text) {}
  explicit InputError(const std::string& text) noexcept : InputError(text.c_str()) {}
  const char* what() const noexcept override { return this->What.Text; }
  /// Told to other ranks with the text.
  ErrorCode Code() const { return this->What.Code; }

private:
  Failure What;
};

/// Thrown out of a stage when the user asked to stop.
struct Aborted : std::exception
{
  const char* what() const noexcept override { return "aborted"; }
};

/// Does the work; the messages of its errors get the prefix.
template <class Work>
void PrefixErrors(const std::string& prefix, const Work& work)
{
  try
  {
    work();
  }
  catch (const InputError& error)
  {
    throw InputError(error.Code(), prefix + error.what());
  }
}

/// Does the work; its errors get the code if they have none. Aborted and lack of memory pass through.
template <class Work>
void ClassifyErrors(ErrorCode code, const Work& work)
{
  try
  {
    work();
  }
  catch (const InputError& error)
  {
    throw InputError(error.Code() == ErrorCode::Unknown ? code : error.Code(), error.what());
  }
  catch (const Aborted&)
  {
    throw;
  }
  catch (const std::bad_alloc&)
  {
    throw;
  }
  catch (const std::exception& error)
  {
    throw InputError(code, error.what());
  }
}

} // namespace vfm
