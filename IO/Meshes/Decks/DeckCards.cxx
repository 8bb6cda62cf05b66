#include "Meshes/Decks/DeckCards.h"

#include <algorithm>
#include <charconv>

namespace vfm
{
namespace
{

constexpr std::size_t LargestWidth = 32;

} // namespace

DeckReal::DeckReal(double value, std::size_t width, RealForm form)
{
  char* const first = this->Characters.data();
  char* const last = first + this->Characters.size() - 1; // Shape may add a point
  this->Length = std::to_chars(first, last, value).ptr - first;
  this->Shape(form);
  for (int digits = 17; this->Length > width; --digits)
  {
    this->Length =
      std::to_chars(first, last, value, std::chars_format::general, digits).ptr - first;
    this->Shape(form);
  }
}

/// Shortens the exponent and leaves out a zero before the point, as the form allows.
void DeckReal::Shape(RealForm form)
{
  if (form == RealForm::Plain)
  {
    return;
  }
  char* const first = this->Characters.data();
  char* end = first + this->Length;
  char* const digits = *first == '-' ? first + 1 : first;
  if (end - digits > 1 && digits[0] == '0' && digits[1] == '.')
  {
    end = std::copy(digits + 1, end, digits);
  }
  char* exponent = std::find(first, end, 'e');
  if (exponent != end && exponent[2] == '0')
  {
    end = std::copy(exponent + 3, end, exponent + 2);
  }
  if (form == RealForm::Nastran)
  {
    const bool hasPoint = std::find(first, exponent, '.') != exponent;
    if (exponent != end && hasPoint)
    {
      end = std::copy(exponent + 1, end, exponent);
    }
    else if (exponent != end)
    {
      *exponent = '.';
    }
    else if (!hasPoint)
    {
      *end++ = '.';
    }
  }
  this->Length = end - first;
}

DeckCards& DeckCards::Text(std::string_view text)
{
  this->File.Add(text);
  return *this;
}

DeckCards& DeckCards::Integer(std::int64_t number, std::size_t width)
{
  char text[LargestWidth];
  const std::size_t length = std::to_chars(text, text + sizeof(text), number).ptr - text;
  this->Blank(width > length ? width - length : 0);
  return this->Text({ text, length });
}

DeckCards& DeckCards::Real(double number, std::size_t width)
{
  const DeckReal real(number, width, this->Form);
  this->Blank(width - real.Text().size());
  return this->Text(real.Text());
}

DeckCards& DeckCards::Blank(std::size_t width)
{
  static constexpr std::string_view blanks = "                                ";
  this->File.Add(blanks.substr(0, width));
  return *this;
}

} // namespace vfm
