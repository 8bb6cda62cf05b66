/**
 * PeriodicPieces: where the pieces of fragments that sides of a periodic domain cut fit together.
 */
#pragma once

#include "Base/Vector3.h"
#include "Ranks/Ranks.h"
#include "Report/MeshData.h"

namespace vfm
{

/// Finds translations of elements, by whole periods, that put each fragment in one piece. The
/// element of a fragment with the lowest id stays. Fragments that are connected with their own
/// copies stay as they are.
/// @param mesh with Fragment, PointIds and ElementIds
/// @return translation of each element; empty if the mesh is not periodic. The same for any number
/// of ranks.
/// @throws InputError if an array is missing, or if MatchFaces does; on all ranks
/// @pre Collective
std::vector<Vector3> FindTranslations(const MeshData& mesh, Ranks& ranks);

} // namespace vfm
