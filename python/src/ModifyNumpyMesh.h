/**
 * ModifyNumpyMesh: splits interfaces of a mesh in numpy arrays, and cuts it into layers.
 */
#pragma once

#include <nanobind/nanobind.h>

namespace vfm
{

/// Adds modify_mesh to the module.
void BindModify(nanobind::module_& module);

} // namespace vfm
