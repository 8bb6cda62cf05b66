/**
 * MeasureMesh: what is reported of a mesh in arrays of numpy.
 */
#pragma once

#include <nanobind/nanobind.h>

namespace vfm
{

/// Adds element_volumes and fragments to the module.
void BindMeasures(nanobind::module_& module);

} // namespace vfm
