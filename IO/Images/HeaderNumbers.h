/**
 * HeaderNumbers: parses numbers of text headers, independent of the locale. The whole word must be
 * a number.
 */
#pragma once

#include "Base/IndexBox.h"

#include <optional>
#include <string>
#include <vector>

namespace vfm
{

/// Returns the words of a text, separated by white space.
std::vector<std::string> SplitWords(const std::string& text);

/// Returns an integer, which may be written as a real number such as 2.0; nothing for any other
/// text and for numbers of 2^53 and more.
std::optional<Index> ParseInteger(const std::string& word);

/// Returns the numbers of a field.
/// @param field  name of the field, for the message
/// @throws InputError  if the text is not `count` numbers
std::vector<double> ParseReals(
  const std::string& field, const std::string& text, std::size_t count);
std::vector<Index> ParseIntegers(
  const std::string& field, const std::string& text, std::size_t count);

} // namespace vfm
