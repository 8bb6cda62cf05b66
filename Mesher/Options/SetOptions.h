/**
 * SetOptions: options set, read and checked by their names. Names and words are taken in any case, with or without spaces; numbers
 * are parsed whole, with a decimal point in any locale.
 */
#pragma once

#include "Options/OptionTable.h"

namespace vfm
{

/// Null where there is none of that name.
const Option* FindOption(const std::string& name, const OptionTable& table = GetOptionTable());

/// Throws InputError, which names the option, the value and what is allowed, when there is no such option, it is one of tetrahedra and
/// options.Elements are not, or the value is not allowed; the options are then as before.
void SetOption(MesherOptions& options, const std::string& name, const std::string& value,
  const OptionTable& table = GetOptionTable());

/// The value as SetOption takes it.
std::string GetOption(const MesherOptions& options, const Option& option);

/// The numbers that an option takes, of a switch or a choice too.
OptionRange RangeOf(const Option& option);

/// Throws InputError, as SetOption does, when a number is out of its range. Of hexahedra the options of tetrahedra are not checked.
void CheckOptions(const MesherOptions& options, const OptionTable& table = GetOptionTable());

/// For help, two lines an option: its name, that of sculptor, what it takes and its default; the first sentence of its text.
std::vector<std::string> DescribeOptions(
  ElementKind elements, const OptionTable& table = GetOptionTable());

} // namespace vfm
