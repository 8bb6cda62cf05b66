/**
 * The active mesh of hexes whose interfaces run through several levels (LevelPlan::FineInterfaces false).
 *
 * Active are the points of nodes within two cells, of their own level, of an interface. A point of finest cells alone moves with
 * its grid node; all others with the node of a level that they stem from (RefinedMesh::Anchors). Colours are the parities of
 * these nodes, level by level: the points of a hex stem from corners of one cell of each level.
 */
#pragma once

#include "Hex/CoarseHexes.h"
#include "Hex/HexTopology.h"
#include "Interface/LevelInterfaces.h"
#include "Labels/Fragments.h"
#include "Smoothing/ActiveMesh.h"

namespace vfm
{

/// mesh: as CoarseHexes::Fill left it. mixed: all mixed nodes of the finest grid. Points of the interface are drawn to the targets of their level.
ActiveMesh MakeActiveLevelHexes(const LevelInterfaces& interfaces, const CoarseHexes& coarse,
  const LabelArray& labels, const std::vector<Index>& mixed, const PointNumbering& numbering,
  const Fragments& fragments, const Partition& partition, const Mesh& mesh);

} // namespace vfm
