/**
 * SurfaceSides: the sides of a body, parts of its surface with a meaning for the user: those that
 * the input names, or those between sharp edges.
 */
#pragma once

#include "Surfaces/InputSurfaces.h"
#include "Surfaces/SurfaceSheets.h"

#include <string>
#include <vector>

namespace vfm
{

/// Sides of the surface of a body.
struct SurfaceSides
{
  std::vector<int> SideOf;        ///< side of each triangle, from 0
  std::vector<std::string> Names; ///< of each side; "" if the input does not name it

  int Count() const { return static_cast<int>(this->Names.size()); }
};

/// Finds the sides of a body: its patches, in their order, if the input names two or more; else its
/// sheets, without names.
SurfaceSides FindSides(const BodySurface& body, const SurfaceSheets& sheets);

} // namespace vfm
