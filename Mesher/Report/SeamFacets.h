/**
 * SeamFacets: the faces of a periodic mesh on the sides where the domain repeats.
 */
#pragma once

#include "Elements/Mesh.h"
#include "Report/MeshData.h"

namespace vfm
{

/// Finds the faces with a copy on the opposite side: another face whose points have the same
/// partners (MeshData::PeriodicPartner).
/// @param faces sides of elements with nothing behind
/// @return per face its side of the domain, 0..5 for -x +x -y +y -z +z, or NoSide
/// @pre Collective
std::vector<int> FindSeamSides(
  const MeshData& mesh, const std::vector<ElementSide>& faces, Ranks& ranks);

/// Adds these faces to Mesh::Facets of a mesh made by LeaveCovering. Interfaces between elements on
/// opposite sides become faces of the sides.
/// @param fields ListDomain of the mesh
/// @pre Collective
void AddSeamFacets(const std::vector<FieldArray>& fields, Ranks& ranks, Mesh& mesh);

} // namespace vfm
