/**
 * SliceFiles: lists the files of slices of one volume in a folder, or that match a pattern.
 */
#pragma once

#include <string>
#include <vector>

namespace vfm
{

/// Returns the suffixes of files of slices, for instance ".png".
const std::vector<std::string>& GetSliceSuffixes();

/// Tests whether a path is a pattern with *, ?, [..] or a number %d, %04d, and not that of a file.
bool IsPattern(const std::string& path);

/// Tests whether a path names slices: a folder with files of slices, or a pattern that ends with a
/// suffix of slices or matches files of slices.
bool AreSlices(const std::string& path);

/// Returns the files of slices in a folder or that match a pattern, in natural order: slice_9.png
/// comes before slice_10.png. Hidden files and files with other suffixes are ignored.
/// @throws InputError  if there are none, or if they have several formats; it says which files
/// there
///   are
std::vector<std::string> ListSlices(const std::string& path);

/// Sorts paths in natural order: numbers in them are compared by value.
void SortNaturally(std::vector<std::string>& paths);

} // namespace vfm
