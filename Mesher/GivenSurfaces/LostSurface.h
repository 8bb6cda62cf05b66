/**
 * LostSurface: the thickness of bodies, and the parts of their surfaces that a mesh lacks.
 */
#pragma once

#include "Base/Runtime.h"
#include "Elements/Mesh.h"
#include "Elements/MeshReport.h"
#include "Fractions/FractionField.h"
#include "GivenSurfaces/BodySurfaces.h"

namespace vfm
{

/// Compares the surface of each body with the mesh at samples (SurfaceSamples.h). A sample is lost
/// if its material is in its cell, does not fill it, and all facets of its material are farther
/// than a cell, or than their longest edge. So samples that other bodies or the domain cut off do
/// not count, nor those where solids of the body overlap. Connected lost samples are a lost part;
/// LostLength, LostThickness and LostPlace describe the largest one that reaches farther than 2.5
/// cells from the mesh, or, if LostArea is 0, the largest.
/// @param mesh  owned elements and their facets, in length units of the grid
/// @return the bodies in the order of BodySurfaces::Bodies
/// @pre Collective.
/// @note Bitwise reproducible on any number of ranks and threads.
std::vector<MeshReport::Body> CompareBodies(const BodySurfaces& surfaces, const CartesianGrid& grid,
  const FractionField& fractions, const Mesh& mesh, Runtime& runtime);

} // namespace vfm
