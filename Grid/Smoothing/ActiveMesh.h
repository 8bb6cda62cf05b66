/**
 * ActiveMesh: the part of a mesh that smoothing moves, and the rim that it needs, as compact arrays. The cost of
 * smoothing follows the interfaces, not the volume. ActiveMeshBuilder fills it.
 *
 * A rank moves the points of the nodes it owns; those of its neighbours come from them (PointExchange.h).
 *
 * The points that may move come first, by node and id. Elements come in the order of their ids, and so do sums over those of
 * a point. Coordinates are grid coordinates (Interface.h).
 */
#pragma once

#include "Interface/Interface.h"
#include "Mesh/Facet.h"
#include "Mesh/Mesh.h"
#include "Mesh/PointExchange.h"
#include "Smoothing/HexRings.h"
#include "Smoothing/MoveOrder.h"
#include "Smoothing/TetStars.h"

namespace vfm
{

/// A surface point is drawn to the target of each pair of labels that meets there.
struct Attachment
{
  Index Target;                   ///< of SurfaceTargets
  std::array<int, 2> Fragments{}; ///< of its first and second label; 0 where not meshed
  double Offset = 0.0; ///< by which its zero level moves to the second label; in the target's frame
  double Weight = 1.0; ///< of its squared distance, among those of all attachments
};

/// A position in ActiveMesh::Elements.
using CornerPosition = std::uint32_t;

struct ActiveMesh
{
  int Corners = 8;              ///< of an element: hexes 8, numbered by bits, x first; tets 4
  std::vector<Vector3> X;       ///< of every point
  std::vector<Index> MeshPoint; ///< its index in the mesh
  std::vector<int>
    PointOf; ///< of each mesh point: its index here, or -1; may go once all is attached
  std::vector<unsigned char> Fixed; ///< bit a: coordinate a stays
  /// Coordinates that are not fixed stay within: where void is not meshed nothing else holds points back.
  Vector3 Lower{ { -1e300, -1e300, -1e300 } }, Upper{ { 1e300, 1e300, 1e300 } };
  std::vector<unsigned char> IsActive; ///< of every point
  std::vector<int> Elements;           ///< Corners points an element
  std::vector<Vector3>
    Widths; ///< of the cell of each element, grid coordinates; one entry when all are equal
  std::vector<float>
    Demands; ///< of each element: the share of the quality that the energy asks for; none: 1 of all
  std::vector<Index>
    CornerOffset; ///< corners at a point: CornerList[CornerOffset[p] .. CornerOffset[p + 1])
  std::vector<CornerPosition>
    CornerList;           ///< positions in Elements, ascending; none at points that are not active
  HexRings Rings;         ///< of hexes; Smoother finds them
  TetStars Stars;         ///< of tets
  MoveOrder Order;        ///< of the owned nodes
  PointExchange Exchange; ///< of the points that move
  std::vector<Index> AttachmentOffset; ///< of each point, as CornerOffset
  std::vector<Attachment> Attachments;
  /// The faces between two fragments with which volumes are measured, on one rank each; their points are those here.
  std::vector<Facet> Facets;
  const double* MeshPoints = nullptr; ///< the points of the mesh
  Vector3 Origin{};                   ///< of grid coordinates
  double Scale = 1.0;                 ///< their unit

  /// Calls visit(point) for the points that this rank moves.
  template <class Visitor>
  void ForOwned(const Visitor& visit) const
  {
    for (const MoveOrder::Group& group : this->Order.Groups())
    {
      for (int point = group.First; point < group.Last; ++point)
      {
        visit(point);
      }
    }
  }
  /// Calls visit(other) for the points of the elements at an active point; for some more than once; the point itself may be left out.
  template <class Visitor>
  void ForAround(int point, const Visitor& visit) const
  {
    if (this->Corners == 8)
    {
      const HexRings::Ring ring = this->Rings.PointsAt(point);
      std::for_each(ring.First, ring.Last, visit);
      return;
    }
    if (this->Stars.Has(point))
    {
      const TetStars::Star star = this->Stars.At(point);
      std::for_each(star.FirstNeighbour, star.LastNeighbour, visit);
      return;
    }
    for (Index at = this->CornerOffset[point]; at < this->CornerOffset[point + 1]; ++at)
    {
      const int* element =
        this->Elements.data() + this->CornerList[at] / this->Corners * this->Corners;
      std::for_each(element, element + this->Corners, visit);
    }
  }
  /// position: in Elements.
  const Vector3& WidthsAt(Index position) const
  {
    return this->Widths[this->Widths.size() == 1 ? 0 : position / this->Corners];
  }
  /// Whether all cells are cubes of one size.
  bool HasCubes() const
  {
    const Vector3& widths = this->Widths[0];
    return this->Widths.size() == 1 && widths[0] == widths[1] && widths[0] == widths[2];
  }
  /// position: in Elements.
  double DemandAt(Index position) const
  {
    return this->Demands.empty() ? 1.0 : this->Demands[position / this->Corners];
  }
  /// Fills X, Fixed, Lower and Upper: the points are where the mesh has them, and stay on the sides of the domain or a little
  /// inside of them. Keeps a pointer to the points of the mesh.
  void PlacePoints(const CartesianGrid& grid, const Mesh& mesh);
  /// Where the mesh has a point.
  Vector3 StartOf(int point) const
  {
    const double* start = this->MeshPoints + 3 * this->MeshPoint[point];
    return { { (start[0] - this->Origin[0]) / this->Scale,
      (start[1] - this->Origin[1]) / this->Scale, (start[2] - this->Origin[2]) / this->Scale } };
  }
  /// Fills CornerOffset and CornerList from Elements.
  void ListCorners();
  /// Of each point of the mesh: whether it is active.
  std::vector<unsigned char> ListMoved(const Mesh& mesh) const
  {
    return this->OfMesh(this->IsActive, mesh);
  }
  /// Values of the points here as those of the points of the mesh, T() of the others.
  template <class T>
  std::vector<T> OfMesh(const std::vector<T>& values, const Mesh& mesh) const
  {
    std::vector<T> all(mesh.PointIds.size());
    for (std::size_t p = 0; p < values.size(); ++p)
    {
      all[this->MeshPoint[p]] = values[p];
    }
    return all;
  }
  /// Writes the coordinates of the active points back into the mesh; those that did not change stay untouched, on all ranks alike.
  void CopyTo(Mesh& mesh, const CartesianGrid& grid) const;
};

/// Bit f set when a point (length units of the grid) lies on side f of the domain.
int FindDomainSides(const CartesianGrid& grid, const double* point);
/// ActiveMesh::Fixed of a point on such sides.
unsigned char FixedOnSides(int sides);

/// Grid coordinates of a point in length units of the grid.
Vector3 ToGrid(const CartesianGrid& grid, const double* point);

/// Whether all cells have the same widths.
bool IsUniform(const CartesianGrid& grid);
/// ActiveMesh::Widths of elements of finest cells.
std::vector<Vector3> WidthsOfCells(
  const CartesianGrid& grid, const Mesh& mesh, const std::vector<Index>& elements);
/// The same of hexes of any level: of the cell that each is or lies in.
std::vector<Vector3> WidthsOfHexes(
  const RefinedGrid& levels, const Mesh& mesh, const std::vector<Index>& hexes);

} // namespace vfm
