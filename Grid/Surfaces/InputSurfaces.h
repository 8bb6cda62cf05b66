/**
 * InputSurfaces: the closed surfaces from which the volume fractions of an input were computed.
 */
#pragma once

#include "Surfaces/ClosedSurface.h"

#include <string>

namespace vfm
{

/// Surface of one body, in length units of the grid.
struct BodySurface
{
  std::string Name;                    ///< name of the array of its fractions
  ClosedSurface Boundary;              ///< canonical: equal for any order of the input
  std::vector<int> Patches;            ///< patch of each triangle, from 0
  std::vector<std::string> PatchNames; ///< names of the patches that the input defines, one or more
};

/// Surfaces of all bodies. Where bodies overlap, the first one keeps its volume. Equal on all
/// ranks.
struct InputSurfaces
{
  std::vector<BodySurface> Bodies;
};

} // namespace vfm
