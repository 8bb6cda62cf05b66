/**
 * FindFaces: binds searches for neighbours of elements and for named sets of faces.
 */
#pragma once

#include <nanobind/nanobind.h>

namespace vfm
{

/// Adds neighbours, side_sets, tagged_faces, cohesive_blocks and face_points to the module.
void BindFaces(nanobind::module_& module);

} // namespace vfm
