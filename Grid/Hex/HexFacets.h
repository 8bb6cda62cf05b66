/**
 * Fragments and facets of a hexahedral mesh.
 */
#pragma once

#include "Hex/HexTopology.h"
#include "Hex/LabelledGrid.h"
#include "Labels/Fragments.h"
#include "Mesh/Facet.h"

namespace vfm
{

/// Fills mesh.Fragment, and mesh.GeometryId of the points inside fragments.
void FillFragments(const LabelledGrid& labelled, const PointNumbering& numbering,
  const Fragments& fragments, Runtime& runtime, Mesh& mesh);

/// The facets of the hexes in HexBox, as far as their cells on both sides are in it. mesh: with fragments. Order: those on sides of the
/// domain by hex; those of finest cells by node and axis, normals along the axis; those between coarse hexes.
std::vector<Facet> FindHexFacets(const LabelledGrid& labelled, const PointNumbering& numbering,
  const Fragments& fragments, const Partition& partition, const Mesh& mesh);

} // namespace vfm
