/**
 * ActiveCorners: the corners of hexes, while points move, in less memory than in the mesh. Where
 * interfaces are everywhere, most hexes are active, and the active mesh has their corners too.
 */
#pragma once

#include "Smoothing/ActiveMesh.h"

namespace vfm
{

/// Takes the corners from a mesh and gives them back.
class ActiveCorners
{
public:
  /// Takes Mesh::Elements if at least half of the hexes are active; otherwise leaves the mesh as it
  /// is.
  ActiveCorners(const ActiveMesh& active, Mesh& mesh);

  /// Fills Mesh::Elements again, with equal values.
  /// @param elements,meshPoints  ActiveMesh::Elements and ActiveMesh::MeshPoint
  void Restore(const std::vector<int>& elements, const std::vector<int>& meshPoints,
    Runtime& runtime, Mesh& mesh) const;

private:
  /// Hexes of the mesh that are all active, or all not.
  struct Run
  {
    Index First; // its first hex
    Index Start; // number of that hex among the active hexes, or among the others
  };

  std::vector<Run> Runs;   // the first one is of active hexes, the second one of others, and so on
  std::vector<int> Others; // corners of the hexes that are not active
  Index Hexes = 0;         // number of hexes of the mesh; 0 if the mesh kept them
};

} // namespace vfm
