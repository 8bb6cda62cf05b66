/**
 * ActiveHexes: the part of a hexahedral mesh that smoothing moves, the points of nodes near an
 * interface. Near means at most two cells away, in cells of the level of the node.
 *
 * A point that only finest cells share moves with its grid node. All other points move with the
 * node of a level from which they stem (RefinedMesh::Anchors). Colours are the parities of these
 * nodes, level by level, because the points of a hex stem from corners of one cell per level.
 */
#pragma once

#include "Elements/Facet.h"
#include "Elements/Hex/LabelledGrid.h"
#include "Interface/LevelInterfaces.h"
#include "Smoothing/ActiveMesh.h"

namespace vfm
{

/// Points within this number of cells around interfaces move, in cells of their level.
constexpr Index MovingRings = 2;

/// Returns the active part of a mesh.
/// @param mesh  result of BuildHexes, in its initial position
/// @param isThin  FindThinFragments
/// @pre Collective among the ranks that share movers.
ActiveMesh MakeActiveHexes(const LabelledGrid& labelled, const Partition& partition,
  const Mesh& mesh, const std::vector<unsigned char>& isThin, Runtime& runtime);

/// Attaches the points on interfaces to the targets of their level.
/// @param[in,out] active  receives the attachments
void AttachHexes(const LevelInterfaces& interfaces, const CoarseHexes& coarse, const Mesh& mesh,
  const std::vector<Facet>& facets, Runtime& runtime, ActiveMesh& active);

} // namespace vfm
