/**
 * ArgumentWords: splits a command line into options and their values.
 */
#pragma once

#include "Ranks/WorkTogether.h"

#include <map>
#include <string>
#include <vector>

namespace vfm
{

/// Values of the given options, by name of the option; a switch has no values. Files without an
/// option are values of --input, but the last one of --output. If all are surfaces, all are inputs.
using GivenArguments = std::map<std::string, std::vector<std::string>>;

/// Rejects the command line with a message that refers to --help.
/// @throws InputError  (WrongArguments) always
[[noreturn]] void RejectArguments(const std::string& message);

/// Splits the words of a command line. A value follows its option as the next word or after "=". If
/// --help or --version is given, only this option is returned.
/// @param words  words without the name of the program, and without "test"
/// @param isTest  `sculptor test`, whose --refine-cells takes no value
/// @throws InputError  (WrongArguments) if an option is unknown, is given twice, or if its value is
///   missing or not expected
GivenArguments ReadWords(const std::vector<std::string>& words, bool isTest);

} // namespace vfm
