/**
 * Fragments, surfaces and classification of a hexahedral mesh.
 */
#pragma once

#include "Hex/HexTopology.h"
#include "Labels/Fragments.h"
#include "Mesh/Geometry.h"

namespace vfm
{

/// Fills mesh.Fragment, mesh.Surfaces, mesh.GeometryDimension and mesh.GeometryId, and the counts of the report.
void FindHexGeometry(const CartesianGrid& grid, const LabelArray& labels,
  const std::vector<Index>& mixed, const Fragments& fragments, const PointNumbering& numbering,
  const Partition& partition, const CoarseHexes* coarse, Mesh& mesh, MeshReport& report);

} // namespace vfm
