/**
 * TextScan: words, numbers and lines of a text in memory.
 */
#pragma once

#include "Base/IndexBox.h"

#include <string>
#include <string_view>

namespace vfm
{

/// Position in a text. Numbers have a decimal point, whatever the locale.
class TextScan
{
public:
  explicit TextScan(std::string_view text) : Text(text) {}

  /// Skips white space and line ends. Returns whether the text ends.
  bool IsAtEnd();
  /// Returns the next word, possibly of a later line; empty at the end of the text.
  std::string_view Word();
  /// Returns the next word of this line; empty at its end.
  std::string_view WordOfLine();
  /// Returns the rest of this line, trimmed, and goes to the next line.
  std::string_view RestOfLine();
  /// Reads the next word, possibly of a later line.
  /// @param what  name of the number in messages
  /// @throws InputError  if it is not a finite number, or an integer from least to most
  double Number(const char* what);
  Index Integer(Index least, Index most, const char* what);

  /// Returns the number of the line, from 1.
  Index Line() const { return this->LineNumber; }
  /// Returns the rest of the text from here on.
  std::string_view Rest() const { return this->Text.substr(this->Place); }
  /// Rejects the text: "in line 7: " and the problem.
  /// @throws InputError  always
  [[noreturn]] void Reject(const std::string& problem) const;

private:
  std::string_view Text;
  std::size_t Place = 0;
  Index LineNumber = 1;
};

/// Returns the finite number of a word; false if it is not one. A plus sign is allowed.
bool ReadReal(std::string_view word, double& number);
/// Returns the integer of a word; false if it is not one or too large.
bool ReadInteger(std::string_view word, Index& number);
/// Returns the first characters of a word in quotes, for messages.
std::string QuoteText(std::string_view word);

} // namespace vfm
