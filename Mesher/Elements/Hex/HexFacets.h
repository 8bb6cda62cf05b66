/**
 * HexFacets: finds the fragments and facets of a hexahedral mesh.
 */
#pragma once

#include "Elements/Facet.h"
#include "Elements/Hex/HexTopology.h"
#include "Elements/Hex/LabelledGrid.h"
#include "Labels/Fragments.h"

namespace vfm
{

/// Fills Mesh::Fragment, and Mesh::GeometryId of the points inside fragments.
void FillFragments(const LabelledGrid& labelled, const PointNumbering& numbering,
  const Fragments& fragments, Runtime& runtime, HexTopology& topology);

/// Returns the facets of the hexes in HexBox whose cells on both sides are in it.
/// @param topology  after FillFragments
/// @return facets on sides of the domain, by hex; then facets of finest cells, by node and axis,
/// with normals along the axis; then facets between coarse hexes
std::vector<Facet> FindHexFacets(const LabelledGrid& labelled, const PointNumbering& numbering,
  const Fragments& fragments, const Partition& partition, Runtime& runtime,
  const HexTopology& topology);

} // namespace vfm
