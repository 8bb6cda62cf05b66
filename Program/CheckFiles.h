/**
 * CheckFiles: checks that outputs replace neither inputs nor each other.
 */
#pragma once

#include "Arguments.h"

namespace vfm
{

/// Checks that every output has its own file, by resolved paths. Devices and pipes can be shared.
/// @throws InputError  (WrongArguments) if an output is the input, a file of slices of it, the
///   table of names or another output
void CheckFiles(const Arguments& arguments);

} // namespace vfm
