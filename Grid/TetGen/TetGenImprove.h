/**
 * What TetGen's optimisation leaves undone near the surface: flips and splits that open the smallest
 * dihedral angles.
 */
#pragma once

#include "TetGen/TetGenSurface.h"

namespace vfm
{
namespace tetfill
{

/// Changes tets that have an angle below 25 degrees where that makes the smallest angle larger; new points
/// are inside. True if anything changed.
bool Improve(const TetGenPart& part, const LocalPart& local, TetGenFill& fill);

/// The points of fill in the local frame.
std::vector<Vector3> LocalPoints(const LocalPart& local, const TetGenFill& fill);

} // namespace tetfill
} // namespace vfm
