/**
 * SplitInterfaces: separates the elements of selected pairs of materials, so that each side has its
 * own nodes.
 *
 * NodeCopies.h states which nodes get copies, and their ids. Points, elements, partners of periodic
 * nodes and nodal state follow; OriginalPointIds are the ids before. Surfaces, curves, vertices and
 * facets remain those of the mesh before. Volumes and elements do not change.
 *
 * A face ends inside the mesh where it meets a third material that is not split from both: there
 * both sides keep one node, as at the tip of a crack. Cohesive elements at such a border have this
 * node on both sides, which Abaqus allows. Faces without any node of their own on both sides get no
 * cohesive element, since they cannot open.
 */
#pragma once

#include "Base/Runtime.h"
#include "Modify/MaterialPairs.h"
#include "Report/Sets/SplitFaces.h"
#include "State/OutputState.h"

#include <functional>

namespace vfm
{

/// Splits the interfaces between selected materials of a finished mesh.
/// @param pairs materials with the ids of mesh.Material
/// @param connection Cohesive: each rank also gets the nodes of both sides of its faces
/// @param fields fields of the whole mesh; SplitConnection (integer), SplitPairs (the pairs that
///   were split, lower id first) and AddedNodes (number of added nodes) are appended
/// @param mesh elements of this rank; PointIds stay ascending
/// @param state state of the mesh; nodal arrays follow the points
/// @pre Collective
void SplitInterfaces(const MaterialPairs& pairs, ConnectionKind connection, Runtime& runtime,
  std::vector<FieldArray>& fields, Mesh& mesh, OutputState& state);

/// Splits interfaces with the connection of the options.
/// @param warn called on rank 0 if no selected materials have a common face; may be empty
/// @return the cohesive elements
/// @pre Collective
std::vector<CohesiveBlock> SplitMesh(const MaterialPairs& pairs, const MesherOptions& options,
  const std::function<void(const std::string&)>& warn, Runtime& runtime,
  std::vector<FieldArray>& fields, Mesh& mesh, OutputState& state);

} // namespace vfm
