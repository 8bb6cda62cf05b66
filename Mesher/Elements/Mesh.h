/**
 * Mesh: a hexahedral or tetrahedral mesh in plain arrays, which vtkUnstructuredGrid can adopt.
 */
#pragma once

#include "Base/Buffer.h"
#include "Base/CartesianGrid.h"
#include "Base/GlobalIds.h"
#include "Elements/ElementShape.h"
#include "Elements/FarMatter.h"
#include "Elements/GeometryTables.h"
#include "Elements/MeshFacet.h"
#include "Elements/MidNodes.h"
#include "Ranks/Ranks.h"

#include <memory>
#include <string>
#include <vector>

namespace vfm
{

class RefinedGrid;

/// Facets of the mesh: faces between two volumes or on a side of the domain. Hexes have quads, tets
/// have triangles. The normal of a facet points from the second material of its pair to the first.
struct SurfaceFacets
{
  Buffer<Index> Points;               ///< mesh points, (facets, Mesh::CornersOfFacet)
  Buffer<int> SurfaceId;              ///< surface of each facet, from 1 over all ranks
  Buffer<int> MaterialPair;           ///< (facets, 2), the smaller first; 0 is void or outside
  std::vector<unsigned char> IsOwned; ///< whether this rank writes the facet
  Buffer<int> DomainSide;             ///< -1, or 0..5 for -x +x -y +y -z +z
};

/// Facet edges where the same surfaces meet. Each edge is stored on one rank.
struct CurveEdges
{
  Buffer<Index> Points; ///< mesh points, (edges, 2), ascending by UnsplitPointIds in each edge
  Buffer<int> CurveId;  ///< curve of each edge, from 1 over all ranks, ascending
};

/// Points where curves meet or end. Each point is stored on one rank.
struct VertexPoints
{
  Buffer<Index> Points; ///< mesh points, ascending
  Buffer<int> VertexId; ///< vertex of each point, from 1 over all ranks, ascending
};

/// Mesh of one rank. It owns its arrays and can be moved, not copied. While it is made, it holds
/// the elements of CartesianGrid::HexBox; KeepOwned leaves the elements of owned cells.
///
/// Corners of elements in VTK's order. The order of the corners of sides is in ElementFaces.h, that
/// of mid nodes in MidNodes.h. HexNumbering.h converts from corners of cells, numbered by bits.
///
///        3               7------6
///       /|\             /|     /|
///      / | \           4------5 |        z  y
///     0..|..2          | 3----|-2        | /
///      \ | /           |/     |/         |/
///       \|/            0------1          +--x
///        1
///
///     side  corners of tets  corners of hexes
///     0     0 1 3            0 4 7 3  (-x)
///     1     1 2 3            1 2 6 5  (+x)
///     2     2 0 3            0 1 5 4  (-y)
///     3     0 2 1            3 7 6 2  (+y)
///     4                      0 3 2 1  (-z)
///     5                      4 5 6 7  (+z)
struct Mesh : NodeCounts
{
  IdScheme Ids = HexIds;  ///< scheme of PointIds and ElementIds
  Buffer<double> Points;  ///< coordinates, (points, 3), length units of the grid
  Buffer<Index> PointIds; ///< global ids, from 1, ascending
  /// Per point, the lowest global id of its copies on opposite sides of a periodic domain, or its
  /// own id; empty for a domain that does not repeat.
  Buffer<Index> PeriodicPartner;
  /// Per point, its global id before interfaces were split; copies of a point have the same. Empty
  /// if none was split. Surfaces, curves and vertices are those before: any copy may stand for the
  /// point.
  Buffer<Index> OriginalPointIds;
  Buffer<Index> OriginalPartner; ///< PeriodicPartner before interfaces were split, in the same way
  Buffer<int> GeometryDimension; ///< dimension per point: 3 volume, .., 0 vertex
  Buffer<int> GeometryId;        ///< number per point in its dimension, from 1; 3: fragment
  Buffer<Index> Elements;        ///< points, (elements, Corners), VTK order
  Buffer<Index> MidPoints;       ///< points, (elements, MidsPerElement); they follow the corners
  std::vector<EdgePull> Pulls;   ///< of interface edges, from FitElements until AddMidNodes
  Buffer<Index> ElementIds;      ///< global ids, from 1, ascending
  Buffer<int> Material;          ///< material per element; 0 is void
  Buffer<int> Fragment;          ///< fragment per element, from 1 over all ranks
  Buffer<float> ScaledJacobian;  ///< quality per element (Quality.h); empty if not computed
  Buffer<int>
    Layer; ///< per element, its layer along a surface, from 1; 0: none. Empty without layers
  SurfaceFacets Surfaces;
  /// Facets by element and side, ascending. A facet is listed for each adjacent element of this
  /// rank, whichever rank owns the facet.
  std::vector<MeshFacet> Facets;
  CurveEdges Curves;
  VertexPoints Vertices;
  /// Material that no fragment has, ascending by cell and material; with MeshOptions::LeavesFar,
  /// until the state is transferred.
  std::vector<FarMatter> Far;
  GeometryTables Tables;                     ///< tables of all ranks
  std::shared_ptr<const RefinedGrid> Levels; ///< refined grid of the elements; never null

  /// Returns the global ids of points before interfaces were split.
  const Buffer<Index>& UnsplitPointIds() const
  {
    return this->OriginalPointIds.empty() ? this->PointIds : this->OriginalPointIds;
  }
  /// Returns ids that copies of points on opposite sides and at split interfaces have in common.
  const Buffer<Index>& CommonIds() const
  {
    return !this->OriginalPartner.empty() ? this->OriginalPartner
      : !this->OriginalPointIds.empty()   ? this->OriginalPointIds
      : this->PeriodicPartner.empty()     ? this->PointIds
                                          : this->PeriodicPartner;
  }

  /// ResizePoints allocates points and their ids; ResizeElements elements, their ids and materials.
  void ResizePoints(Index count)
  {
    this->Points = Buffer<double>(3 * count);
    this->PointIds = Buffer<Index>(count);
  }
  void ResizeElements(Index count)
  {
    this->Elements = Buffer<Index>(this->Corners * count);
    this->ElementIds = Buffer<Index>(count);
    this->Material = Buffer<int>(count);
  }
  Vector3 PointAt(Index point) const
  {
    const double* x = this->Points.data() + 3 * point;
    return { { x[0], x[1], x[2] } };
  }
  void SetPoint(Index point, const Vector3& x, Index id)
  {
    std::copy(x.begin(), x.end(), this->Points.data() + 3 * point);
    this->PointIds[point] = id;
  }
  /// Sets an element.
  /// @param points  mesh points in VTK order
  template <class ElementPoints>
  void SetElement(Index element, const ElementPoints& points, Index id, int material)
  {
    std::copy(points.begin(), points.end(), this->Elements.data() + this->Corners * element);
    this->ElementIds[element] = id;
    this->Material[element] = material;
  }
};

/// Returns the grid node of a point from its id; the owner of the node owns the point. For tets it
/// is the node of the block in which the point starts.
Index3 NodeOfPoint(const CartesianGrid& grid, const Mesh& mesh, Index id);
/// Returns the cells of the grid from which an element was made, by its id: one cell, or all finest
/// cells in a coarser cell. For a tet, which surrounds a face of the grid, it is the cell above the
/// face, on an upper side of the domain the cell below it, on a flat seam the cell that it is in.
/// @pre The element was not made by TetGen.
IndexBox CellsOfElement(const CartesianGrid& grid, const Mesh& mesh, Index id);
/// Returns the lowest cell of CellsOfElement.
Index3 CellOfElement(const CartesianGrid& grid, const Mesh& mesh, Index id);

/// Checks that no rank has more points than 32-bit integers can number.
/// @throws InputError  on all ranks if a rank has too many points
/// @pre Collective.
void CheckNumberOfPoints(Index points, Ranks& ranks);

} // namespace vfm
