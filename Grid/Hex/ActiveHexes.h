/**
 * The active part of a hexahedral mesh: the points of the mixed nodes and of two rings of cells around them.
 */
#pragma once

#include "Hex/HexTopology.h"
#include "Labels/Fragments.h"
#include "Smoothing/ActiveMesh.h"

namespace vfm
{

/// Points, hexes, attachments and facets. Inside a grid node S comes first, then its I.
ActiveMesh MakeActiveHexes(const Interface& interface, const PointNumbering& numbering,
  const LabelArray& labels, const Fragments& fragments, const Partition& partition,
  const Mesh& mesh);

} // namespace vfm
