/**
 * An independent look at the geometry of a mesh: its surfaces, curves, vertices, and what bounds
 * what.
 */
#pragma once

#include "RankMeshes.h"

namespace vfm
{
namespace testing
{

/// "", or what does not follow from the elements and the facets with their surfaces: curves and
/// vertices, the classification of points, the tables.
std::string FindGeometryProblem(const MergedMesh& mesh);

} // namespace testing
} // namespace vfm
