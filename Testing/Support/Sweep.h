/**
 * Seeds of random sweeps. Environment variables make sweeps longer or shorter.
 */
#pragma once

#include <vector>

namespace vfm
{
namespace testing
{

/// Returns the seeds 0 to count-1, or one of several parts of them. VFM_SWEEP multiplies
/// their number (0.1: a tenth, at least one per part; 10: ten times as many).
/// VFM_SEEDS=first:count replaces them.
std::vector<unsigned> ListSeeds(unsigned count, unsigned part = 0, unsigned parts = 1);

/// Returns whether sweeps have at least their default size: some events occur only in many meshes.
bool IsWholeSweep();

} // namespace testing
} // namespace vfm
