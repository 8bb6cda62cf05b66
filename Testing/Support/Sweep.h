/**
 * The seeds of random sweeps, longer or shorter by the environment.
 */
#pragma once

#include <vector>

namespace vfm
{
namespace testing
{

/// The seeds 0..count-1, or one of several parts of them. In the environment, VFM_SWEEP multiplies
/// their number (0.1: a tenth, at least one a part; 10: ten times as many), VFM_SEEDS=first:count
/// gives them instead.
std::vector<unsigned> ListSeeds(unsigned count, unsigned part = 0, unsigned parts = 1);

/// Whether the environment leaves the sweeps at their size or longer: some things happen in many
/// meshes only.
bool IsWholeSweep();

} // namespace testing
} // namespace vfm
