/**
 * TetGenImprove: flips and splits that increase the smallest dihedral angles, mostly near the
 * surface, where TetGen's optimisation leaves poor tets.
 */
#pragma once

#include "TetGen/TetGenSurface.h"

namespace vfm
{
namespace tetfill
{

/// Changes tets that have a dihedral angle below 25 degrees, where this increases the smallest
/// angle. New points are inside the surface.
/// @return whether any tet changed
bool Improve(const TetGenPart& part, const LocalPart& local, TetGenFill& fill);

/// Returns the points of fill in the local frame.
std::vector<Vector3> LocalPoints(const LocalPart& local, const TetGenFill& fill);

} // namespace tetfill
} // namespace vfm
