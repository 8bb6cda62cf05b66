/**
 * SliceGaps: finds numbers that are missing among the names of slices.
 */
#pragma once

#include <string>
#include <vector>

namespace vfm
{

/// Returns a warning if a number is missing among the names of slices, or "". The usual step of a
/// number is its smallest: 0, 10, 20 lack nothing.
/// @param files  paths in natural order
std::string WarnOfGaps(const std::vector<std::string>& files);

} // namespace vfm
