/**
 * BindBodies: closed surfaces of bodies, for Python.
 */
#pragma once

#include "Surfaces/InputSurfaces.h"

#include <nanobind/nanobind.h>

#include <memory>

namespace vfm
{

/// Surfaces of bodies; constant and shared, so that a run can use them without a copy.
struct Bodies
{
  std::shared_ptr<const InputSurfaces> Surfaces;
  std::string Note{}; ///< repairs of the surfaces; or empty
};

/// Binds the class Bodies.
void BindBodies(nanobind::module_& module);

} // namespace vfm
