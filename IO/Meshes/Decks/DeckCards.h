/**
 * DeckCards: writes the lines of a solver's input file, with fields of fixed width.
 */
#pragma once

#include "Meshes/Files/OutputFile.h"

#include <array>
#include <string_view>

namespace vfm
{

/// Forms of real numbers.
enum class RealForm
{
  Plain,   ///< 1e-05, 0.5
  Compact, ///< 1e-5, .5
  Nastran  ///< 1.-5, .5; always with a point, which makes it a real number
};

/// Real number as text, without allocation.
class DeckReal
{
public:
  /// Formats a number as the shortest text that is read back as the same value. If it exceeds the
  /// width, digits are removed until the text fits.
  /// @param width  greatest number of characters, 9 or more
  DeckReal(double value, std::size_t width, RealForm form);
  std::string_view Text() const { return { this->Characters.data(), this->Length }; }

private:
  void Shape(RealForm form);

  std::array<char, 48> Characters;
  std::size_t Length;
};

/// A file of lines. Fields are at the right end of their columns.
/// @throws InputError  (each function) if OutputFile does
class DeckCards
{
public:
  DeckCards(const std::string& path, RealForm form) : File(path), Form(form) {}

  DeckCards& Text(std::string_view text);
  DeckCards& Integer(std::int64_t number, std::size_t width);
  DeckCards& Real(double number, std::size_t width);
  DeckCards& Blank(std::size_t width);
  void End() { this->File.Add("\n"); }
  /// Writes a text as a line.
  void Line(std::string_view text) { this->Text(text).End(); }
  void Close() { this->File.Close(); }

private:
  OutputFile File;
  RealForm Form;
};

} // namespace vfm
