/**
 * ExodusInput: reads an Exodus file, or a decomposed one (FILE.N.0 to FILE.N.N-1).
 */
#pragma once

#include "Input.h"
#include "Ranks/Ranks.h"

namespace vfm
{

struct Arguments;

/// Reads the element blocks of all files; each rank reads some of the files. The element variables
/// that the arguments name are read, by default all. The label array "object_id" holds block ids.
/// @throws InputError  (UnreadableInput) if a file cannot be read or a named variable is missing
/// @pre Collective
Input ReadExodus(const Arguments& arguments, Ranks& ranks);

} // namespace vfm
