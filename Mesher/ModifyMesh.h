/**
 * ModifyMesh: cuts layers and splits interfaces in a mesh that an earlier run made.
 *
 * The result is the mesh that a run with the options gives, bitwise: layers and copies of nodes
 * follow from the mesh alone. Positions of layers in a mesh with DomainFrame may differ by
 * rounding, because a run cuts them before it rotates the mesh. Mid nodes are not added: on
 * interfaces they lie on quadrics that are fitted to the volume fractions, and so do the corners of
 * a mesh of second order.
 */
#pragma once

#include "Mesher.h"
#include "Summary/MeshData.h"

namespace vfm
{

/// Input of ModifyMesh.
struct ModifyInput
{
  MeshData Data;                      ///< mesh of this rank with all arrays and fields
  std::vector<std::string> Extensive; ///< element arrays whose values are sums over an element
  SurfaceFacets Surfaces; ///< of a mesh on a single rank; empty: found from the arrays
  CurveEdges Curves;      ///< of a mesh on a single rank, or empty
  std::function<void(const std::string&)> Warn; ///< called only on rank 0; may be empty
};

/// A modified mesh.
struct ModifiedMesh
{
  Mesh TheMesh;      ///< materials have the ids of the user
  OutputState State; ///< element arrays that are not part of Mesh
  std::vector<TransferredArray> PointArrays; ///< point arrays that are not part of Mesh
  std::vector<CohesiveBlock> Cohesive;       ///< cohesive elements of this rank
  FieldArrays Fields;
  MeshReport Report;       ///< with layers: quality of all elements, and Materials
  std::vector<int> Labels; ///< material of each row of Report.Materials
};

/// Cuts layers, then splits interfaces.
/// @param options  LayerOptions, SplitInterfaces and Connection; others are not used
/// @throws InputError if options are not valid, or the mesh lacks an array, was split before, has
/// layers already, has mid nodes or repeated elements; the same message on all ranks
/// @pre Collective
/// @note The same mesh on any number of ranks.
ModifiedMesh ModifyMesh(ModifyInput input, const MesherOptions& options, Runtime& runtime);

} // namespace vfm
