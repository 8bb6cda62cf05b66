/**
 * MeshOfData: a mesh that an earlier run made, from its arrays, so that it can be modified.
 */
#pragma once

#include "Base/Runtime.h"
#include "Options/MesherOptions.h"
#include "Report/MeshData.h"
#include "State/OutputState.h"

namespace vfm
{

/// Throws InputError if a mesh lacks what modifications need, or cannot get the layers of the
/// options.
void CheckMesh(const MeshData& mesh, const MesherOptions& options);
/// Throws InputError if an element occurs on several ranks.
/// @pre Collective
void CheckElementIds(const MeshData& mesh, Ranks& ranks);

/// Copies a mesh of the mesher, with its facets; its surfaces, curves and vertices are empty.
/// @param mesh  linear elements with MaterialId, FragmentId, ids and geometry
/// @param labels  materials, ascending; Mesh::Material are their numbers
/// @throws InputError if FindMeshFacets does
/// @pre Collective
Mesh MakeMeshOf(const MeshData& mesh, const std::vector<int>& labels, Ranks& ranks);

/// Sets the surfaces and curves of a mesh on a single rank.
/// @param surfaces  with the ids of materials; IsOwned is set
/// @param labels  as for MakeMeshOf
void SetGeometry(
  const std::vector<int>& labels, SurfaceFacets surfaces, CurveEdges curves, Mesh& mesh);

/// Copies the element arrays that are not part of Mesh.
/// @param extensive  names of arrays whose values are sums over an element
/// @throws InputError if an extensive array is missing or not of type double
OutputState MakeStateOf(const MeshData& mesh, const std::vector<std::string>& extensive);

/// Copies the point arrays that are not part of Mesh.
/// @param before  the mesh as MakeMeshOf got it
/// @param mesh  the same mesh, which may be split since
std::vector<TransferredArray> CopyPointArrays(const MeshData& before, const Mesh& mesh);

/// Adds the facets to Mesh::Surfaces, with the numbers that the mesher gave their surfaces: those
/// of their pairs of fragments, or of a fragment and a side of the domain, in ascending order.
/// @param data  the mesh as MakeMeshOf got it
/// @throws InputError if parts of the mesh are missing, on all ranks
/// @pre Collective
void AddSurfaces(const MeshData& data, Ranks& ranks, Mesh& mesh);

} // namespace vfm
