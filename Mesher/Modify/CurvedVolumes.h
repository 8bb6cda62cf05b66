/**
 * CurvedVolumes: volumes of materials in meshes of second-order elements.
 */
#pragma once

#include "Base/Runtime.h"
#include "Modify/PeriodImages.h"

namespace vfm
{

/// Returns the volume of the elements of each material, integrated exactly.
/// @param labels  Mesh::Material of each material
/// @param fields  ListDomain of the mesh
/// @pre Collective over runtime.Group().
/// @note The same bits on any number of ranks.
std::vector<double> MeasureCurvedVolumes(
  const Mesh& mesh, const std::vector<int>& labels, const FieldArrays& fields, Runtime& runtime);

} // namespace vfm
