/**
 * ExodusInput: reads an Exodus file, or a decomposed one (FILE.N.0 to FILE.N.N-1), by VTK's reader.
 */
#pragma once

#include "Ranks/Ranks.h"
#include "ReaderSteps.h"

#include <string>
#include <vector>

namespace vfm
{

class VtkMessages;

/// Returns the supported suffixes, for instance ".e".
std::vector<std::string> GetExodusSuffixes();
/// Tests whether a path has one of these suffixes, or is FILE.N.RANK with any FILE, a part of a
/// decomposed file (N may be 1).
bool IsExodusFile(const std::string& path);

/// Reads the element blocks of all files; each rank reads some of the files. The element variables
/// that the arguments name are read, by default all. The label array "object_id" holds block ids.
/// @param messages  receives the messages of VTK
/// @throws InputError  (UnreadableInput) if a file cannot be read or a named variable is missing
/// @pre Collective
Input ReadExodus(const Arguments& arguments, VtkMessages& messages, Ranks& ranks);

} // namespace vfm
