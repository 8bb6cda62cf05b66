/**
 * An independent check of the geometry of a mesh: its surfaces, curves and vertices, and
 * which of them bound each other.
 */
#pragma once

#include "RankMeshes.h"

namespace vfm
{
namespace testing
{

/// Returns an empty string or the first problem. Curves, vertices, classification of points and
/// tables must follow from the elements, the facets and their surfaces.
std::string FindGeometryProblem(const MergedMesh& mesh);

} // namespace testing
} // namespace vfm
