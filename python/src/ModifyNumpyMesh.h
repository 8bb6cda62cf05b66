/**
 * ModifyNumpyMesh: splits interfaces of a mesh in numpy arrays, cuts it into layers, and groups its
 * elements in bins.
 */
#pragma once

#include <nanobind/nanobind.h>

namespace vfm
{

/// Adds modify_mesh and bin_materials to the module.
void BindModify(nanobind::module_& module);

} // namespace vfm
