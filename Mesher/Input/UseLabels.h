/**
 * UseLabels: from the numbers of materials to what the user calls them.
 */
#pragma once

#include "Input/InputFields.h"
#include "Mesh/Mesh.h"

namespace vfm
{

/// In elements, facets and tables of surfaces.
void UseLabels(const Materials& table, Mesh& mesh);

} // namespace vfm
