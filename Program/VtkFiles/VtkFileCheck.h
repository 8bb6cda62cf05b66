/**
 * VtkFileCheck: checks a file of VTK, legacy or XML, before a reader of VTK opens it.
 *
 * The readers end the program, or need memory without bound, if a file contradicts itself. Checked
 * are the type of the file, version and byte order, the extents and numbers of points and cells,
 * the place and length of each array, and the files that a file names.
 */
#pragma once

#include <string>

namespace vfm
{

/// Checks a file by its suffix; files of other suffixes are not checked.
/// @param part,parts  of the files that this file names, only those with number `part` modulo
///   `parts` are checked
/// @throws InputError  if the file or one that it names cannot be read, is damaged, or is of
///   another type; the message contains the path
void CheckVtkFile(const std::string& path, int part, int parts);

} // namespace vfm
