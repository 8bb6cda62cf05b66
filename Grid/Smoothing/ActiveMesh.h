/**
 * ActiveMesh: the part of a mesh that smoothing moves, and the rim that it needs, as compact arrays. The cost of
 * smoothing follows the interfaces, not the volume. ActiveHexes and ActiveTets fill it.
 *
 * A rank moves the points of the nodes it owns; those of its neighbours come from them (PointExchange.h).
 *
 * Points come in the order of their ids, so that sums over the elements of a point run in id order.
 * Coordinates are grid coordinates (Interface.h).
 */
#pragma once

#include "Interface/Interface.h"
#include "Mesh/Mesh.h"

namespace vfm
{

/// A surface point is drawn to the target of each pair of labels that meets there.
struct Attachment
{
  Index Target;                   ///< of SurfaceTargets
  std::array<int, 2> Fragments{}; ///< of its first and second label; 0 where not meshed
  double Offset = 0.0; ///< by which its zero level moves to the second label; in the target's frame
};

/// A face between two fragments: what volumes are measured with, on one rank each.
struct InterfaceFacet
{
  std::array<int, 4> Points;    ///< around it; the last twice in triangles
  std::array<int, 2> Fragments; ///< behind and before it (by the normal); 0 where not meshed
};

struct ActiveMesh
{
  /// The points of one grid node, moved one after another.
  struct Group
  {
    int First, Last;
  };

  int Corners = 8;                  ///< of an element: hexes 8, numbered by bits, x first; tets 4
  std::vector<Vector3> X;           ///< of every point
  std::vector<Vector3> Start;       ///< where each point started
  std::vector<Index> MeshPoint;     ///< its index in the mesh
  std::vector<int> PointOf;         ///< of each mesh point: its index here, or -1
  std::vector<unsigned char> Fixed; ///< bit a: coordinate a stays
  std::vector<unsigned char> IsActive; ///< of every point
  std::vector<int> Elements;           ///< Corners points an element
  std::vector<Vector3>
    Widths; ///< of the cell of each element, grid coordinates; one entry when all are equal
  std::vector<Index>
    CornerOffset; ///< corners at a point: CornerList[CornerOffset[p] .. CornerOffset[p + 1])
  std::vector<Index>
    CornerList; ///< positions in Elements, ascending; none at points that are not active
  /// Of the owned nodes; groups of one colour share no element. As many colours on all ranks.
  std::vector<std::vector<Group>> Colours = std::vector<std::vector<Group>>(8);
  std::vector<Index> AttachmentOffset; ///< of each point, as CornerOffset
  std::vector<Attachment> Attachments;
  std::vector<InterfaceFacet> Facets;

  /// position: in Elements.
  const Vector3& WidthsAt(Index position) const
  {
    return this->Widths[this->Widths.size() == 1 ? 0 : position / this->Corners];
  }
  /// Fills Fixed: points on a side of the domain stay on it.
  void FixOnDomain(const CartesianGrid& grid, const Mesh& mesh);
  /// Fills CornerOffset and CornerList from Elements.
  void ListCorners();
  /// Appends a point at x (grid units of the user), which is where it starts.
  void AddPoint(const CartesianGrid& grid, const Mesh& mesh, Index meshPoint, bool active);
  /// Of each point of the mesh: whether it is active.
  std::vector<unsigned char> ListMoved(const Mesh& mesh) const;
  /// Writes the coordinates of the active points back into the mesh; fixed coordinates stay untouched.
  void CopyTo(Mesh& mesh, const CartesianGrid& grid) const;
};

/// Bit f set when a point (length units of the grid) lies on side f of the domain.
int FindDomainSides(const CartesianGrid& grid, const double* point);

/// Grid coordinates of a point in length units of the grid.
Vector3 ToGrid(const CartesianGrid& grid, const double* point);

/// Whether all cells have the same widths.
bool IsUniform(const CartesianGrid& grid);
/// Widths of a cell, grid coordinates.
Vector3 CellWidths(const CartesianGrid& grid, const Index3& cell);
/// The same of the cell of any level that a hex is or lies in; hex: its index.
Vector3 WidthsOfHex(const RefinedGrid& levels, const Mesh& mesh, Index hex);

} // namespace vfm
