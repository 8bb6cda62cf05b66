/**
 * ArgumentWords: the options that a command line gives, and how a wrong one ends the program.
 */
#pragma once

#include "Ranks/WorkTogether.h"

#include <map>
#include <string>
#include <vector>

namespace vfm
{

/// Values of the options that are given, by names of options; a switch has none. Files without an option are values of --input and
/// --output, in this order.
using GivenArguments = std::map<std::string, std::vector<std::string>>;

/// Throws InputError (WrongArguments).
[[noreturn]] void RejectArguments(const std::string& message);

/// Values may follow an option as the next word or after "=". Of words with --help or --version only this option is returned.
/// Throws InputError (WrongArguments) when an option is unknown, is given twice, lacks a value or takes none.
/// @param words  without the program's name; of the test, whose --refine-cells takes no value, also without "test"
GivenArguments ReadWords(const std::vector<std::string>& words, bool isTest);

} // namespace vfm
