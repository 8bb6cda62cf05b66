/**
 * LegacyCheck: checks a file in VTK's legacy format (.vtk) before VTK's reader opens it.
 *
 * The reader ends the program, or needs memory without bound, if the numbers of points, cells and
 * values of a file contradict each other or its length.
 */
#pragma once

#include <string>

namespace vfm
{

/// Checks the structure of a legacy file: its data set, and the length of each array.
/// @throws InputError  if the file cannot be read, is damaged, or holds no grid of cells; the
///   message does not contain the path
void CheckLegacyFile(const std::string& path);

} // namespace vfm
