/**
 * WriteFile: binds the writers of mesh files.
 */
#pragma once

#include <nanobind/nanobind.h>

namespace vfm
{

/// Adds write_mesh and write_report to the module.
void BindWriters(nanobind::module_& module);

} // namespace vfm
