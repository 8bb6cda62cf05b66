/**
 * What ParaView's reader of Exodus files takes on trust.
 */
#pragma once

#include <string>

namespace vfm
{

/// Throws InputError (UnreadableInput) for a file that is cut off or damaged, which the reader would read as zeros; that has another number
/// of times than the first of those it belongs to, which the reader would give nothing of; or that its library would end
/// the program for. Files that are not of netCDF's classic kinds pass.
void CheckExodusFile(const std::string& path, const std::string& first);

} // namespace vfm
