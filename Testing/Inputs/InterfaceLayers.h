/**
 * Layers of hexahedra along all interfaces, for tests.
 */
#pragma once

#include "Geometry/Quality.h"
#include "Modify/CutLayers.h"

namespace vfm
{
namespace testing
{

/// Cuts the hexahedra on both sides of all interfaces into layers, and measures quality.
inline void CutAtInterfaces(
  const LayerSpacing& spacing, Runtime& runtime, Mesh& mesh, MeshReport& report)
{
  std::vector<ColumnBase> bases;
  for (const MeshFacet& facet : mesh.Facets)
  {
    if (facet.DomainSide == -1)
    {
      bases.push_back({ facet.Element, facet.Side, true });
    }
  }
  OutputState state;
  CutLayers(
    FindLayerColumns(mesh, bases, runtime.Group()), spacing, Vector3{}, runtime, mesh, state);
  ComputeQuality(mesh, runtime, report);
}

} // namespace testing
} // namespace vfm
