/**
 * ActiveMesh: the part of a mesh that smoothing moves, with the fixed points of its elements (the
 * rim), as compact arrays. Smoothing therefore costs time in proportion to the interfaces, not to
 * the volume. ActiveMeshBuilder fills it.
 *
 * A rank moves the points of the nodes that it owns and receives the positions of its neighbours'
 * points (PointExchange.h).
 *
 * Points that may move come first, sorted by node and id. Elements, and sums over the elements at a
 * point, are in the order of element ids. Coordinates are grid coordinates (Interface.h).
 */
#pragma once

#include "Elements/BarrierElements.h"
#include "Elements/Facet.h"
#include "Elements/GridCoordinates.h"
#include "Elements/PointExchange.h"
#include "Interface/Interface.h"
#include "Smoothing/CodedPoints.h"
#include "Smoothing/HexRings.h"
#include "Smoothing/MoveOrder.h"
#include "Smoothing/TetStars.h"

namespace vfm
{

/// Attraction of a surface point to the target of a pair of labels that meet at it.
struct Attachment
{
  int Target; ///< number in SurfaceTargets
  /// Fragments of the first and second label; 0 if not meshed.
  std::array<int, 2> Fragments{};
  float Weight = 1.0f; ///< weight of the squared distance; greater near sharp features
  /// Shift of the target's zero level towards the second label, in the target's frame.
  double Offset = 0.0;
};

/// Face between two fragments.
struct ActiveFacet
{
  std::array<int, 4> Points;    ///< points of the active mesh; triangles repeat the last one
  std::array<int, 2> Fragments; ///< fragment behind and before; 0: not meshed
};

/// Factor of the target quality of elements that are only a barrier (BarrierElements.h). Their
/// energy grows without bound as they degenerate, but hardly pulls points before.
constexpr float BarrierDemand = 0.3f;

/// Bounds of the coordinates of points.
struct MoveBounds
{
  Vector3 Lower{ { -1e300, -1e300, -1e300 } }, Upper{ { 1e300, 1e300, 1e300 } };
};

/// Position in ActiveMesh::Elements or Attachments.
using CornerPosition = std::uint32_t;

/// Active part of a mesh as compact arrays. It owns its arrays but refers to the points of the
/// mesh, which must outlive it. Reading is thread safe; each point may be moved by one thread.
struct ActiveMesh
{
  /// Corners per element: 8 for hexes, numbered by bits, x lowest; 4 for tets.
  int Corners = 8;
  std::vector<Vector3> X;     ///< position of each point
  std::vector<int> MeshPoint; ///< index of each point in the mesh
  /// Index here of each mesh point, or -1; may be freed once all is attached.
  std::vector<int> PointOf;
  std::vector<unsigned char> Fixed; ///< bit a is set if coordinate a is fixed
  /// Bounds of coordinates that are not fixed. Where void is not meshed, nothing else holds
  /// points back.
  MoveBounds Bounds;
  std::vector<MoveBounds> OwnBounds;   ///< bounds of each point between flat seams; empty: none
  std::vector<unsigned char> IsActive; ///< whether each point may move
  /// Whether each point must stay near its start; empty: none.
  std::vector<unsigned char> StaysNear;
  std::vector<int> Elements; ///< Corners points per element
  /// Widths of the cell of each element, grid coordinates; one entry if all are equal.
  std::vector<Vector3> Widths;
  /// Factor of each element's target quality, up to 1; empty if all are 1.
  std::vector<float> Demands;
  /// Index in the mesh of each element; of hexes only if there are thin fragments.
  std::vector<Index> MeshElement;
  /// Fragment of each element that may get a lower demand (LowerDemands); 0: none. Empty: none may.
  std::vector<int> YieldingFragments;
  /// Corners at point p: CornerList[CornerOffset[p]] to before CornerList[CornerOffset[p + 1]].
  std::vector<CornerPosition> CornerOffset;
  /// Positions in Elements, ascending; points that are not active have no entries.
  std::vector<CornerPosition> CornerList;
  HexRings Rings;         ///< rings of hexes, found by Smoother like the lists of corners
  TetStars Stars;         ///< stars of tets
  MoveOrder Order;        ///< order of the owned nodes
  PointExchange Exchange; ///< exchange of the points that move
  /// First attachment of each point, like CornerOffset.
  std::vector<CornerPosition> AttachmentOffset;
  std::vector<Attachment> Attachments;
  /// Whether each point is attracted to an edge of a given surface that fades out; empty: none.
  std::vector<unsigned char> AtFadingEdge;
  /// Faces by which volumes are measured, each on one rank.
  std::vector<ActiveFacet> Facets;
  /// Lower and upper point of each column of a flat layer (FlatColumns.h); empty: none. Upper
  /// points are not active: they have the positions of the lower ones, except along ColumnAxis.
  std::vector<std::array<int, 2>> Columns;
  int ColumnAxis = -1;
  /// Points of the mesh, in length units of the grid. They are not read if there are Starts.
  const double* MeshPoints = nullptr;
  CodedPoints Starts; ///< where the points here are in the mesh (CodeStarts); may be empty
  Vector3 Origin{};   ///< origin of grid coordinates
  double Scale = 1.0; ///< unit of grid coordinates

  const MoveBounds& BoundsOf(int point) const
  {
    return this->OwnBounds.empty() ? this->Bounds : this->OwnBounds[point];
  }
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
  /// Does the same with several threads.
  template <class Visitor>
  void ForOwned(Runtime& runtime, const Visitor& visit) const
  {
    const std::vector<MoveOrder::Group>& groups = this->Order.Groups();
    ForEach(runtime, groups.size(),
      [&](Index g)
      {
        for (int point = groups[g].First; point < groups[g].Last; ++point)
        {
          visit(point);
        }
      });
  }
  /// Returns whether a point is attracted to a sharp feature (AttachFeatures.h).
  bool IsNearFeature(int point) const
  {
    return std::any_of(this->Attachments.begin() + this->AttachmentOffset[point],
      this->Attachments.begin() + this->AttachmentOffset[point + 1],
      [](const Attachment& a) { return a.Weight > 1.0f; });
  }
  /// Moves the upper points of columns to where the lower ones are.
  void AlignColumns()
  {
    for (const auto& [lower, upper] : this->Columns)
    {
      const double height = this->X[upper][this->ColumnAxis];
      this->X[upper] = this->X[lower];
      this->X[upper][this->ColumnAxis] = height;
    }
  }
  bool HasHexes() const { return AreHexes(this->Corners); }
  /// Calls visit(other) for the points of the elements at an active point. Some are visited more
  /// than once; the point itself may be left out.
  template <class Visitor>
  void ForAround(int point, const Visitor& visit) const
  {
    if (this->HasHexes())
    {
      const HexRings::Ring ring = this->Rings.PointsAt(point);
      for (int n = 0; n < ring.Count; ++n)
      {
        visit(ring[n]);
      }
      return;
    }
    if (this->Stars.Has(point))
    {
      const TetStars::Star star = this->Stars.At(point);
      std::for_each(star.FirstNeighbour, star.LastNeighbour, visit);
      return;
    }
    for (CornerPosition at = this->CornerOffset[point]; at < this->CornerOffset[point + 1]; ++at)
    {
      const int* element =
        this->Elements.data() + this->CornerList[at] / this->Corners * this->Corners;
      std::for_each(element, element + this->Corners, visit);
    }
  }
  /// The same without the far corners of hexes, whose energy there does not depend on the point.
  template <class Visitor>
  void ForNear(int point, const Visitor& visit) const
  {
    if (!this->HasHexes())
    {
      this->ForAround(point, visit);
      return;
    }
    const HexRings::Ring ring = this->Rings.PointsAt(point);
    for (int n = 0; n < ring.Near; ++n)
    {
      visit(ring[n]);
    }
  }
  /// Returns the element of a position in Elements. Shifts, because divisions take time in
  /// energies.
  CornerPosition ElementAt(CornerPosition position) const
  {
    return this->HasHexes() ? position / 8 : position / 4;
  }
  /// position: in Elements.
  const Vector3& WidthsAt(CornerPosition position) const
  {
    return this->Widths[this->Widths.size() == 1 ? 0 : this->ElementAt(position)];
  }
  /// Returns whether all cells are cubes of equal size.
  bool HasCubes() const
  {
    const Vector3& widths = this->Widths[0];
    return this->Widths.size() == 1 && widths[0] == widths[1] && widths[0] == widths[2];
  }
  /// position: in Elements.
  double DemandAt(CornerPosition position) const
  {
    return this->Demands.empty() ? 1.0 : this->Demands[this->ElementAt(position)];
  }
  /// Returns whether an element is only a barrier. position: in Elements.
  bool IsBarrierAt(CornerPosition position) const
  {
    return !this->Demands.empty() && this->Demands[this->ElementAt(position)] == BarrierDemand;
  }
  /// Sets Demands for the elements that are only a barrier, and StaysNear for their points and the
  /// points of the elements at these.
  /// @param elements  index in the mesh of each element
  /// @pre Collective among the ranks that share points.
  void SetBarrier(
    const Mesh& mesh, const BarrierElements& barrier, const std::vector<Index>& elements);
  /// Sets YieldingFragments: the elements of flagged fragments.
  /// @param elements  index in the mesh of each element
  /// @param isThin  FindThinFragments
  void SetYielding(
    const Mesh& mesh, const std::vector<unsigned char>& isThin, const std::vector<Index>& elements);
  /// Lowers the demands of flagged elements to at most `demand`.
  void LowerDemandsOf(const std::vector<unsigned char>& elements, float demand);
  /// Lowers the demands of the yielding elements of flagged fragments to at most `demand`.
  void LowerDemands(const std::vector<unsigned char>& fragments, float demand);
  /// Fills X, Fixed and bounds from the positions in the mesh. Points on sides of the domain and
  /// flat seams stay there; all others stay 0.01 cells inside. Keeps a pointer to the points of the
  /// mesh.
  void PlacePoints(const CartesianGrid& grid, const Mesh& mesh);
  /// Sets OwnBounds: points between flat seams stay in the period in which they start.
  void BoundBySeams(const CartesianGrid& grid, const Mesh& mesh);
  /// Returns the coordinates of a point in MeshPoints.
  const double* InMeshPoints(int point) const
  {
    return this->MeshPoints + 3 * static_cast<Index>(this->MeshPoint[point]);
  }
  /// Returns the position of a point in the mesh, grid coordinates.
  Vector3 StartOf(int point) const
  {
    if (!this->Starts.IsEmpty())
    {
      return this->Starts.ConvertedAt(point);
    }
    const double* start = this->InMeshPoints(point);
    return { { (start[0] - this->Origin[0]) / this->Scale,
      (start[1] - this->Origin[1]) / this->Scale, (start[2] - this->Origin[2]) / this->Scale } };
  }
  /// Begins to load the start of a point.
  void PrefetchStart(int point) const
  {
    if (!this->Starts.IsEmpty())
    {
      this->Starts.Prefetch(point);
      return;
    }
    __builtin_prefetch(this->InMeshPoints(point));
  }
  /// Fills Starts, which take less memory than the points of the mesh and are in the order of the
  /// points here. They stay empty if points start at too many different places.
  void CodeStarts();
  /// Returns where a point may be: within its bounds, near its start if it must stay there, and at
  /// its fixed coordinates.
  MoveBounds RangeOf(int point) const;
  /// Returns whether a point that must stay near its start may be at x; true for all others.
  bool IsNearStart(int point, const Vector3& x) const;
  /// Fills CornerOffset, CornerList and Stars from Elements.
  /// @throws InputError  if this rank has more corners than 32 bits can number
  void ListCorners();
  /// Returns whether each point of the mesh is active.
  std::vector<unsigned char> ListMoved(const Mesh& mesh) const
  {
    return this->OfMesh(this->IsActive, mesh);
  }
  /// Returns values of the points here as values of all mesh points; T() for the others.
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
  /// Writes the coordinates of the active points to the mesh. Unchanged coordinates are not
  /// written, so they stay bitwise identical on all ranks.
  void CopyTo(Mesh& mesh, const CartesianGrid& grid) const;

private:
  Vector3 ReachOf(int point) const;
};

/// Returns ActiveMesh::Fixed of a point on these sides of the domain.
unsigned char FixedOnSides(int sides);

/// Returns ActiveMesh::Widths of elements that were made in finest cells.
/// @param elements  indices in the mesh
std::vector<Vector3> WidthsOfCells(
  const CartesianGrid& grid, const Mesh& mesh, const std::vector<Index>& elements);
/// Returns ActiveMesh::Widths of elements of any level: widths of the cell to which each element
/// belongs.
std::vector<Vector3> WidthsOfLeaves(
  const RefinedGrid& levels, const Mesh& mesh, const std::vector<Index>& elements);

} // namespace vfm
