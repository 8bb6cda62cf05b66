/**
 * AbaqusText: names and numbers as Abaqus and CalculiX read them.
 */
#pragma once

#include <array>
#include <set>
#include <string>
#include <string_view>

namespace vfm
{

/// Names of sets, each given out once. CalculiX loses the load on a surface, without a word, when an element set has its name:
/// so surfaces and element sets share one list.
class AbaqusNames
{
public:
  /// The name in capitals, letters and digits of ASCII, what lies between them as one '_', from a letter on ("S_" goes before
  /// anything else), 80 characters at most. One that was given out ends in _2, _3 and so on.
  std::string Add(const std::string& name);

private:
  std::set<std::string> Used;
};

/// Abaqus and CalculiX read 20 characters of a number and drop the others.
constexpr std::size_t AbaqusNumberLength = 20;

/// A number as text, without the heap.
class AbaqusNumber
{
public:
  /// The shortest text that reads back as the value or, where that is longer than 20 characters, the nearest value of those
  /// that fit: the error is 5e-14 of the value at most (5e-13 where the exponent has three digits).
  explicit AbaqusNumber(double value);
  std::string_view Text() const { return { this->Characters.data(), this->Length }; }

private:
  std::array<char, 40> Characters;
  std::size_t Length;
};

} // namespace vfm
