/**
 * ReadInput: reads an input of any supported format.
 */
#pragma once

#include "Arguments.h"
#include "Ranks/Ranks.h"
#include "ReaderSteps.h"

#include <string>
#include <vector>

namespace vfm
{

/// Returns all supported suffixes, for instance ".vti".
std::vector<std::string> GetInputSuffixes();
/// Checks that the format of a file is supported.
/// @throws InputError  (WrongArguments) if it is not
void CheckInputSuffix(const std::string& path);

/// Reads the input of the arguments; each rank gets a part of it.
/// @throws InputError  (UnreadableInput) if it cannot be read
/// @pre Collective
Input ReadInput(const Arguments& arguments, Ranks& ranks);

} // namespace vfm
