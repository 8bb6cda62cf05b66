/**
 * MeasureMesh: measures meshes in numpy arrays.
 */
#pragma once

#include <nanobind/nanobind.h>

namespace vfm
{

/// Adds element_volumes and fragments to the module.
void BindMeasures(nanobind::module_& module);

} // namespace vfm
