/**
 * BindChoice: the choice of the arrays of materials, for Python.
 */
#pragma once

#include <nanobind/nanobind.h>

namespace vfm
{

/// Adds choose_materials() and the class of its result to the module.
void BindChoice(nanobind::module_& module);

} // namespace vfm
