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
#include "Report/MeshData.h"

namespace vfm
{

/// Input of ModifyMesh.
struct ModifyInput
{
  MeshData Data;                      ///< mesh of this rank with all arrays and fields
  std::vector<std::string> Extensive; ///< element arrays whose values are sums over an element
  /// Of a mesh on a single rank, whose points have ascending ids; they are modified, too. Empty:
  /// the surfaces are found from the arrays.
  SurfaceFacets Surfaces;
  CurveEdges Curves;                            ///< in the same way
  std::function<void(const std::string&)> Warn; ///< called only on rank 0; may be empty
};

/// A modified mesh. State are the element arrays that are not part of Mesh. MaterialFields are the
/// columns that layers change, with MaterialId; none without layers.
struct ModifiedMesh : MesherResult
{
  std::vector<TransferredArray> PointArrays; ///< point arrays that are not part of Mesh
};

/// Cuts layers, then splits interfaces.
/// @param options  LayerOptions, SplitInterfaces and Connection; others are not used
/// @throws InputError if options are not valid, or the mesh lacks an array, was split before, has
/// layers already, has mid nodes or repeated elements; the same message on all ranks
/// @pre Collective
/// @note The same mesh on any number of ranks.
ModifiedMesh ModifyMesh(ModifyInput input, const MesherOptions& options, Runtime& runtime);

} // namespace vfm
