/**
 * CheckGridFile: binds the check of files of VTK (IO/GridFiles).
 */
#pragma once

#include <nanobind/nanobind.h>

namespace vfm
{

/// Defines check_vtk_file.
void BindChecks(nanobind::module_& module);

} // namespace vfm
