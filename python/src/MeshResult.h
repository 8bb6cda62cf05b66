/**
 * MeshResult: what a run made, as a dict of arrays of numpy.
 */
#pragma once

#include "Mesher.h"

#include <nanobind/nanobind.h>

namespace vfm
{

/// The keys are those of _core.pyi. The memory of the mesh goes over to numpy.
nanobind::dict ToPython(MesherResult result);

} // namespace vfm
