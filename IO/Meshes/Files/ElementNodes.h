/**
 * ElementNodes: the nodes of second-order elements in the order of a file format.
 */
#pragma once

#include "Report/MeshData.h"

#include <initializer_list>

namespace vfm
{

/// Orders of mid nodes: for each place in the file, the mid node in VTK's order. An empty list
/// keeps VTK's order.
struct MidOrders
{
  std::vector<int> Of20, Of27, Of10;
};

/// The nodes of elements: corners in VTK's order, then mid nodes in the order of a format.
class ElementNodes
{
public:
  /// @param mesh  must outlive the object
  ElementNodes(const MeshData& mesh, const MidOrders& orders);

  int Count() const { return this->TheMesh.NodesPerElement(); }
  /// Returns the points of an element, until the next call.
  const Index* Of(Index element);

private:
  const MeshData& TheMesh;
  const std::vector<int> Order;
  std::vector<Index> Points;
};

/// Returns the points of a side of an element, counterclockwise seen from outside: its corners,
/// then the mid nodes of its edges, then its centre.
std::vector<Index> NodesOfSide(const MeshData& mesh, Index element, int side);

/// Checks that a format has elements with the mid nodes of the mesh.
/// @param mids  supported numbers of mid nodes per element, in addition to 0
/// @throws InputError  with the name of the format
void RequireNodes(const MeshData& mesh, std::initializer_list<int> mids, const char* format);

} // namespace vfm
