/**
 * MesherResult: what a run of the mesher gives.
 */
#pragma once

#include "Elements/Mesh.h"
#include "Elements/MeshReport.h"
#include "Report/MeshFields.h"
#include "Report/Sets/SplitFaces.h"
#include "State/OutputState.h"

#include <vector>

namespace vfm
{

/// Result of a run.
struct MesherResult
{
  Mesh TheMesh; ///< elements of this rank, in world coordinates; materials have the ids of the user
  MeshReport Report;
  OutputState State;
  std::vector<CohesiveBlock> Cohesive; ///< cohesive elements of this rank
  /// Field data of the whole mesh: ListSides, ListReport, ListDomain (MeshFields.h), ListBalance.
  /// RankFragments and RankTargetVolume, if they exist, are of this rank (FragmentTargets.h).
  FieldArrays Fields;
  /// Table with one row per material: ListMaterials (MeshFields.h), ListBalance (StateBalance.h).
  FieldArrays MaterialFields;
};

} // namespace vfm
