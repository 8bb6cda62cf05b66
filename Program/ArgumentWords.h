/**
 * ArgumentWords: the words of a command line, one after another, and how a wrong one ends the program.
 */
#pragma once

#include "Stage.h"

#include <set>
#include <string>
#include <vector>

namespace vfm
{

/// Throws ProgramError (WrongArguments).
[[noreturn]] void RefuseArguments(const std::string& message);

/// The words of a command line, taken from the front.
class ArgumentWords
{
public:
  explicit ArgumentWords(const std::vector<std::string>& words);
  bool HasWord() const { return this->Next < this->Left.size(); }
  bool HasValue() const { return this->HasWord() && !IsOption(this->Left[this->Next]); }
  /// Whether the next word stood behind the = of an option.
  bool HasJoinedValue() const { return this->Joined.count(this->Next) > 0; }
  std::string Take() { return this->Left[this->Next++]; }
  std::string TakeValue(const std::string& option);
  /// Names with commas between them, each once.
  std::vector<std::string> TakeList(const std::string& option);

private:
  static bool IsOption(const std::string& word) { return word.compare(0, 2, "--") == 0; }
  std::vector<std::string> Left;
  std::set<std::size_t> Joined; // places of values behind an =
  std::size_t Next = 0;
};

} // namespace vfm
