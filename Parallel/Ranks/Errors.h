/**
 * Errors that end the work of a rank. They contain their texts, so they can be thrown and sent to
 * other ranks even without free memory.
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

/// Kind of an error. Programs and hosts translate it to their own numbers.
enum class ErrorCode : std::int32_t
{
  Unknown, ///< not classified; a caller sets the code (ClassifyErrors)
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

/// Failure of a rank in the form in which ranks send it. Longer texts are truncated.
struct Failure
{
  static constexpr std::size_t LongestText = 2032;

  std::int32_t Rank; ///< the failed rank; the lowest one that the sender knows of
  ErrorCode Code;
  char Text[LongestText];

  Failure() noexcept : Failure(NoRank, ErrorCode::Unknown, "") {}
  Failure(int rank, ErrorCode code, const char* text) noexcept : Rank(rank), Code(code)
  {
    const std::size_t length = std::min(std::strlen(text), LongestText - 1);
    std::memcpy(this->Text, text, length);
    std::memset(this->Text + length, 0, LongestText - length);
  }
  /// Orders failures by rank. All ranks report the smallest failure.
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

/// Returns the failure "Not enough memory", with the number of the rank if there are several.
inline Failure LackOfMemory(int rank, int count) noexcept
{
  char text[64] = "Not enough memory.";
  if (count > 1)
  {
    std::snprintf(text, sizeof(text), "Not enough memory on rank %d.", rank);
  }
  return { rank, ErrorCode::OutOfMemory, text };
}

/// Error of the input, or of the kind given by the code. what() names the array, the value and the
/// place, and says what to do. Texts longer than Failure::LongestText are truncated.
class InputError : public std::exception
{
public:
  explicit InputError(const Failure& failure) noexcept : What(failure) {}
  InputError(ErrorCode code, const std::string& text) noexcept : What(0, code, text.c_str()) {}
  explicit InputError(const char* text) noexcept : What(0, ErrorCode::Unknown, text) {}
  explicit InputError(const std::string& text) noexcept : InputError(text.c_str()) {}
  const char* what() const noexcept override { return this->What.Text; }
  /// Returns the code, which other ranks receive with the text.
  ErrorCode Code() const { return this->What.Code; }

private:
  Failure What;
};

/// Exception of a stage that the user stopped.
struct Aborted : std::exception
{
  const char* what() const noexcept override { return "aborted"; }
};

/// Runs work() and adds the prefix to the messages of its InputErrors.
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

/// Runs work() and converts its exceptions to InputErrors. The code is set if an error has none.
/// Aborted and std::bad_alloc are not converted.
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
