/**
 * ActiveMesh: the part of a hexahedral mesh that smoothing moves, and the rim that it needs, as compact
 * arrays. Active are the points of the mixed nodes and of two rings of cells around them; the cost of
 * smoothing follows the interfaces, not the volume.
 *
 * A rank moves the points of the nodes it owns; those of its neighbours come from them (PointExchange.h).
 *
 * Points come in the order of their ids, so that sums over the hexes of a point run in id order.
 * Coordinates are grid coordinates (Interface.h). Hex corners are numbered by bits, x first.
 */
#pragma once

#include "HexTopology.h"
#include "Interface.h"

namespace vfm
{

struct ActiveMesh
{
  ActiveMesh(const Interface& interface, const PointNumbering& numbering, const LabelArray& labels,
    const Partition& partition, const HexMesh& mesh);

  /// Writes the coordinates of the active points back into the mesh; fixed coordinates stay untouched.
  void CopyTo(HexMesh& mesh, const CartesianGrid& grid) const;

  /// The points of one grid node, moved one after another.
  struct Group
  {
    int First, Last;
  };

  std::vector<Vector3> X;              ///< of every point
  std::vector<Index> MeshPoint;        ///< its index in the mesh
  std::vector<unsigned char> Fixed;    ///< bit a: coordinate a stays
  std::vector<unsigned char> IsActive; ///< of every point
  std::vector<std::array<int, 8>> Hexes;
  std::vector<Vector3>
    Widths; ///< of the cell of each hex, grid coordinates; one entry when all are equal
  std::vector<Index>
    CornerOffset; ///< corners at an active point: Corners[CornerOffset[p] .. CornerOffset[p + 1])
  std::vector<Index> Corners; ///< 8 * hex + corner, ascending; none at points that are not active
  std::array<std::vector<Group>, 8>
    Colours; ///< of the owned nodes; groups of one colour share no hex
  std::vector<int>
    SurfacePoint; ///< point of the n-th node of the interface; -1 far from the owned cells
  std::vector<Index> TargetNode; ///< of each point: n where it is a surface point, else -1

  const Vector3& WidthsOf(Index hex) const
  {
    return this->Widths[this->Widths.size() == 1 ? 0 : hex];
  }

private:
  std::vector<Index> FindActiveNodes(
    const Interface& interface, const PointNumbering& numbering, const LabelArray& labels) const;
  void AddHexes(const CartesianGrid& grid, const HexMesh& mesh, std::vector<int>& pointOf);
  void AddGroups(const Interface& interface, const std::vector<Index>& nodes,
    const PointNumbering& numbering, const Partition& partition, const std::vector<int>& pointOf,
    const HexMesh& mesh);
  void ListCorners();
};

} // namespace vfm
