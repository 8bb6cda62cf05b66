/**
 * VtkNumbers: numbers in the types of VTK's arrays, from words and bytes of files.
 */
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace vfm
{

/// Type of the values of an array.
struct VtkType
{
  enum Kinds
  {
    Bit, ///< eight values in a byte
    Signed,
    Unsigned,
    Real
  };

  Kinds Kind = Signed;
  int Bytes = 1;         ///< of a value, 1 for bits
  bool IsFinite = false; ///< words may not be nan or inf
};

/// Receives the values of an array in their order.
using VisitVtkValue = std::function<void(double)>;

/// Returns the value of a word; nothing if VTK's readers convert it to another value or do not read
/// it, because it is not a number or out of the range of the type. Reals that are too small are 0.
std::optional<double> ParseVtkNumber(const std::string& word, const VtkType& type);

/// Returns the value of bytes in the order of a file. Not for bits.
double DecodeVtkNumber(const unsigned char* bytes, const VtkType& type, bool isBigEndian);

/// Rejects a word of an array.
/// @param index  place of the value in the array, from 1
/// @throws InputError  always: "has '1.5' as value 3, where an integer from 0 to 255 is required."
[[noreturn]] void RejectVtkNumber(std::int64_t index, const std::string& word, const VtkType& type);

/// Returns the first characters of a word of a file in quotes, for messages.
std::string QuoteWord(std::string word);

} // namespace vfm
