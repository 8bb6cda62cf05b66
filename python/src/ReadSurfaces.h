/**
 * ReadSurfaces: binds the reader of surfaces of triangles.
 */
#pragma once

#include <nanobind/nanobind.h>

namespace vfm
{

/// Adds read_surface and is_surface_file to the module.
void BindSurfaceFiles(nanobind::module_& module);

} // namespace vfm
