/**
 * SurfaceFields: closed surfaces as arrays of field data. Volume Fraction Of Surface writes them
 * beside its fractions, and the mesh filters use them.
 */
#pragma once

#include "Surfaces/FlatSurfaces.h"

#include <memory>

class vtkDataObject;
class vtkFieldData;

namespace vfm
{

/// Adds the arrays InputSurfacePoints (three coordinates), InputSurfaceTriangles (three points),
/// InputSurfaceBodies and InputSurfacePatches (one number per triangle), InputSurfaceNames and
/// InputSurfacePatchNames (texts). Adds nothing if there are no triangles.
void AddSurfaceFields(const FlatSurfaces& surfaces, vtkFieldData* fields);

/// Removes these arrays, which VTK passes from the input of a filter to its outputs.
void RemoveSurfaceFields(vtkFieldData* fields);

/// Returns the surfaces in these arrays of the data object, or of its first block that has them, of
/// the lowest rank that has them; null if there are none.
/// @param data  may be null
/// @throws InputError  if RestoreSurfaces does
/// @pre Collective
std::shared_ptr<const InputSurfaces> FindSurfaces(vtkDataObject* data, Ranks& ranks);

} // namespace vfm
