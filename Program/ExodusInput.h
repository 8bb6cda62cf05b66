/**
 * ExodusInput: Exodus files, one or a decomposed one (FILE.N.0 to FILE.N.N-1), by VTK's reader.
 */
#pragma once

#include "Ranks/Ranks.h"
#include "ReaderSteps.h"

#include <string>
#include <vector>

namespace vfm
{

class VtkMessages;

/// Such as ".e".
std::vector<std::string> GetExodusSuffixes();
/// By its name: with one of these suffixes, or as FILE.N.RANK with any FILE, a part of a decomposed one (N may be 1).
bool IsExodusFile(const std::string& path);

/// Collective. The element blocks of all files, dealt to the ranks by file, with the element variables that the arguments name,
/// or all. A label array of real type whose values are whole becomes one of integers, since Exodus files hold no others; the label
/// array "object_id" is the id of the element block. messages: where VTK's go. Throws InputError (UnreadableInput).
Input ReadExodus(const Arguments& arguments, VtkMessages& messages, Ranks& ranks);

} // namespace vfm
