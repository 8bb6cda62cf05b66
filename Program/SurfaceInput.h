/**
 * SurfaceInput: reads closed surfaces, and computes their volume fractions on a grid around them.
 */
#pragma once

#include "Arguments.h"
#include "Input.h"

#include <iosfwd>

namespace vfm
{

/// Reads the surfaces of the arguments; each rank gets all of them and the fractions of a slab. A
/// body is a material, with the name of its file.
/// @throws InputError  (UnreadableInput) if a surface cannot be read or is open, two have the same
///   name, or there would be too many cells
/// @pre Collective
Input ReadSurfaces(const Arguments& arguments, Ranks& ranks);

/// Reads the surfaces and prints on rank 0 what they hold, and the grid that they would get.
/// @throws InputError  same conditions as ReadSurfaces
/// @pre Collective
void ListSurfaces(const Arguments& arguments, Ranks& ranks, std::ostream& to);

} // namespace vfm
