/**
 * RunOptions: the options of a run as a class of Python.
 */
#pragma once

#include <nanobind/nanobind.h>

namespace vfm
{

/// Options: MesherOptions by the names that the table has for Python; describe_options.
void BindOptions(nanobind::module_& module);

} // namespace vfm
