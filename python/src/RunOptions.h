/**
 * RunOptions: the options of a run as a Python class.
 */
#pragma once

#include <nanobind/nanobind.h>

namespace vfm
{

/// Adds the class Options (MesherOptions, with the Python names of the table) and list_options.
void BindOptions(nanobind::module_& module);

} // namespace vfm
