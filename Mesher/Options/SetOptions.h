/**
 * SetOptions: sets, reads and checks options by name. Upper and lower case and spaces in names and
 * words do not matter. Numbers have a decimal point in any locale; trailing characters are errors.
 */
#pragma once

#include "Options/OptionTable.h"

namespace vfm
{

/// Returns the option with a name, or null.
const Option* FindOption(const std::string& name, const OptionTable& table = GetOptionTable());

/// Sets an option. If it throws, the options do not change.
/// @param value text as GetOption returns it; words of a choice, or their numbers
/// @throws InputError if there is no such option, if it applies to tetrahedra only and
/// options.Elements are hexahedra, or if the value is not allowed; the message names the option,
/// the value and the allowed values
void SetOption(MesherOptions& options, const std::string& name, const std::string& value,
  const OptionTable& table = GetOptionTable());

///@{ Set an option that exists, as the accessors of filters do. Return whether its value changed.
/// SetClamped clamps choices, and integers except options for tetrahedra, to their range. SetText
/// does not check the text; CheckOptions does.
bool SetClamped(MesherOptions& options, const std::string& name, double value);
bool SetText(MesherOptions& options, const std::string& name, const std::string& value);
///@}

/// Returns the value of an option as text that SetOption accepts.
std::string GetOption(const MesherOptions& options, const Option& option);

/// Returns the options that differ from their defaults, in the order of the table.
std::vector<const Option*> ListChangedOptions(
  const MesherOptions& options, const OptionTable& table = GetOptionTable());

/// Returns the range of numbers that an option accepts; for switches and choices, of their words.
OptionRange RangeOf(const Option& option);

/// Checks the ranges of all numbers; options for tetrahedra only if options.Elements
/// are tetrahedra.
/// @throws InputError as SetOption does
void CheckOptions(const MesherOptions& options, const OptionTable& table = GetOptionTable());

/// Returns help texts, two lines per option: name, argument of sculptor, allowed values, default;
/// then the first sentence of its meaning.
std::vector<std::string> DescribeOptions(
  ElementKind elements, const OptionTable& table = GetOptionTable());

} // namespace vfm
