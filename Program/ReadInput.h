/**
 * ReadInput: the files that VTK reads, each rank its piece.
 */
#pragma once

#include "Arguments.h"
#include "Ranks/Ranks.h"
#include "ReaderSteps.h"

#include <string>
#include <vector>

namespace vfm
{

/// Such as ".vti".
std::vector<std::string> GetInputSuffixes();
/// Throws InputError (WrongArguments) when files of that name are not read.
void CheckInputSuffix(const std::string& path);

/// Collective. Throws InputError (UnreadableInput).
Input ReadInput(const Arguments& arguments, Ranks& ranks);

} // namespace vfm
