/**
 * Nodes of second-order elements, for tests.
 */
#pragma once

#include "Elements/Mesh.h"
#include "Modify/CurvedElement.h"

namespace vfm
{
namespace testing
{

/// Returns the nodes of an element without those of faces and the centre.
inline CurvedElement::Nodes NodesOf(const Mesh& mesh, Index element)
{
  CurvedElement::Nodes nodes{};
  for (int c = 0; c < mesh.Corners; ++c)
  {
    nodes[c] = mesh.PointAt(mesh.Elements[mesh.Corners * element + c]);
  }
  for (int e = 0; e < MidNodes(mesh.Corners, mesh.MidsPerElement).Edges; ++e)
  {
    nodes[mesh.Corners + e] = mesh.PointAt(mesh.MidPoints[mesh.MidsPerElement * element + e]);
  }
  return nodes;
}

} // namespace testing
} // namespace vfm
