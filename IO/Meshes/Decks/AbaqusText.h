/**
 * AbaqusText: formats names and numbers for Abaqus and CalculiX.
 */
#pragma once

#include "Summary/UniqueNames.h"

#include <array>
#include <string>
#include <string_view>

namespace vfm
{

/// List of unique names of sets. Surfaces and element sets must share one list: if a surface and an
/// element set have the same name, CalculiX ignores the load on the surface without a message.
class AbaqusNames
{
public:
  /// Returns a valid name that was not returned before. It is in capitals and has at most 80
  /// characters. Characters other than ASCII letters and digits become '_', several of them only
  /// one. "S_" is prepended if it would not begin with a letter. A name that exists gets the ending
  /// _2, _3 and so on.
  std::string Add(const std::string& name);

private:
  UniqueNames Used{ 80 };
};

/// Number of characters of a number that Abaqus and CalculiX read; they ignore further ones.
constexpr std::size_t AbaqusNumberLength = 20;

/// Number as text, without allocation.
class AbaqusNumber
{
public:
  /// Formats a number as the shortest text that is read back as the same value. If that exceeds 20
  /// characters, digits are removed until the text fits. The relative error is then at most 5e-14,
  /// or 5e-13 if the exponent has three digits.
  explicit AbaqusNumber(double value);
  std::string_view Text() const { return { this->Characters.data(), this->Length }; }

private:
  std::array<char, 40> Characters;
  std::size_t Length;
};

} // namespace vfm
