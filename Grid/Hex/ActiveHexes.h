/**
 * The active part of a hexahedral mesh: the points of nodes within two cells, of their own level, of an interface.
 *
 * A point of finest cells alone moves with its grid node; all others with the node of a level that they stem from
 * (RefinedMesh::Anchors). Colours are the parities of these nodes, level by level: the points of a hex stem from corners of one
 * cell of each level.
 */
#pragma once

#include "Hex/LabelledGrid.h"
#include "Interface/LevelInterfaces.h"
#include "Mesh/Facet.h"
#include "Smoothing/ActiveMesh.h"

namespace vfm
{

/// mesh: as CoarseHexes::Fill left it. Collective among peers.
ActiveMesh MakeActiveHexes(
  const LabelledGrid& labelled, const Partition& partition, const Mesh& mesh, Runtime& runtime);

/// Draws the points on interfaces to the targets of their level.
void AttachHexes(const LevelInterfaces& interfaces, const CoarseHexes& coarse, const Mesh& mesh,
  const std::vector<Facet>& facets, Runtime& runtime, ActiveMesh& active);

} // namespace vfm
