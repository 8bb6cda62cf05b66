/**
 * MeshResult: the result of a run as a dict of numpy arrays.
 */
#pragma once

#include "Mesher.h"

#include <nanobind/nanobind.h>

namespace vfm
{

/// Converts a result; _core.pyi lists the keys. numpy takes over the memory of the mesh.
nanobind::dict ToPython(MesherResult result);

} // namespace vfm
