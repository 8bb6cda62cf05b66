#include "Surfaces/TextScan.h"

#include "Base/ParseText.h"
#include "Ranks/Errors.h"

#include <charconv>
#include <cmath>

namespace vfm
{
namespace
{

bool IsSpace(char c)
{
  return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\v' || c == '\f';
}

} // namespace

bool ReadReal(std::string_view word, double& number)
{
  const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  if (error == std::errc() && stop == word.data() + word.size())
  {
    return std::isfinite(number);
  }
  const auto found = ParseReal(std::string(word)); // a plus sign, or a number near 0
  number = found.value_or(0.0);
  return found.has_value();
}

bool ReadInteger(std::string_view word, Index& number)
{
  const std::size_t begin = word.size() > 1 && word[0] == '+' && word[1] != '-' ? 1 : 0;
  const char* end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data() + begin, end, number);
  return error == std::errc() && stop == end;
}

std::string QuoteText(std::string_view word)
{
  constexpr std::size_t longest = 40;
  return "'" + std::string(word.substr(0, longest)) + (word.size() > longest ? "..." : "") + "'";
}

bool TextScan::IsAtEnd()
{
  while (this->Place < this->Text.size() && IsSpace(this->Text[this->Place]))
  {
    this->LineNumber += this->Text[this->Place++] == '\n';
  }
  return this->Place == this->Text.size();
}

std::string_view TextScan::Word()
{
  return this->IsAtEnd() ? std::string_view() : this->WordOfLine();
}

std::string_view TextScan::WordOfLine()
{
  const auto isHere = [this] { return this->Place < this->Text.size(); };
  while (isHere() && this->Text[this->Place] != '\n' && IsSpace(this->Text[this->Place]))
  {
    ++this->Place;
  }
  const std::size_t begin = this->Place;
  while (isHere() && !IsSpace(this->Text[this->Place]))
  {
    ++this->Place;
  }
  return this->Text.substr(begin, this->Place - begin);
}

std::string_view TextScan::RestOfLine()
{
  const std::size_t end = std::min(this->Text.find('\n', this->Place), this->Text.size());
  std::string_view rest = this->Text.substr(this->Place, end - this->Place);
  while (!rest.empty() && IsSpace(rest.front()))
  {
    rest.remove_prefix(1);
  }
  while (!rest.empty() && IsSpace(rest.back()))
  {
    rest.remove_suffix(1);
  }
  this->LineNumber += end < this->Text.size();
  this->Place = std::min(end + 1, this->Text.size());
  return rest;
}

double TextScan::Number(const char* what)
{
  const std::string_view word = this->Word();
  double number = 0.0;
  if (!ReadReal(word, number))
  {
    this->Reject(word.empty() ? std::string("the file ends before ") + what + "."
                              : QuoteText(word) + " is not a finite number (" + what + ").");
  }
  return number;
}

Index TextScan::Integer(Index least, Index most, const char* what)
{
  const std::string_view word = this->Word();
  Index number = 0;
  if (!ReadInteger(word, number) || number < least || number > most)
  {
    this->Reject(word.empty() ? std::string("the file ends before ") + what + "."
                              : QuoteText(word) + " is not an integer from " +
          std::to_string(least) + " to " + std::to_string(most) + " (" + what + ").");
  }
  return number;
}

void TextScan::Reject(const std::string& problem) const
{
  throw InputError(
    "it is truncated or damaged in line " + std::to_string(this->LineNumber) + ": " + problem);
}

} // namespace vfm
