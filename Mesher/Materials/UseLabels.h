/**
 * UseLabels: replaces material numbers by the ids of the user.
 */
#pragma once

#include "Elements/Mesh.h"
#include "Input/InputFields.h"

namespace vfm
{

/// Replaces material numbers in elements, facets and tables of surfaces.
void UseLabels(const Materials& table, Mesh& mesh);

/// Replaces material numbers in a list.
void UseLabels(const Materials& table, std::vector<int>& materials);

} // namespace vfm
