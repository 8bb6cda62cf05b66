/**
 * RunOptions: the options of a run as a class of Python.
 */
#pragma once

#include <nanobind/nanobind.h>

namespace vfm
{

/// Options: MesherOptions with the defaults of the filters.
void BindOptions(nanobind::module_& module);

} // namespace vfm
