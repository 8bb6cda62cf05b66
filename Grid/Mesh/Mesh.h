/**
 * A hexahedral or tetrahedral mesh as plain arrays, ready to be adopted by vtkUnstructuredGrid.
 */
#pragma once

#include "Base/Buffer.h"
#include "Base/CartesianGrid.h"
#include "Base/GlobalIds.h"
#include "Mesh/GeometryTables.h"
#include "Mesh/MeshFacet.h"
#include "Ranks/Ranks.h"

#include <memory>
#include <string>
#include <vector>

namespace vfm
{

class RefinedGrid;

/// The faces between two volumes, or on a side of the domain: quads of hexes, triangles of tets.
/// The normal of a facet points from the second material of its pair to the first.
struct SurfaceFacets
{
  Buffer<Index> Points;               ///< Mesh::CornersOfFacet a facet: indices of mesh points
  Buffer<int> SurfaceId;              ///< from 1, over all ranks
  Buffer<int> MaterialPair;           ///< 2 a facet, the smaller first; 0 is void or outside
  std::vector<unsigned char> IsOwned; ///< whether this rank writes the facet
  Buffer<int> DomainSide;             ///< -1, or 0..5 for -x +x -y +y -z +z
};

/// The edges of the facets where the same surfaces meet. Each is on one rank alone.
struct CurveEdges
{
  Buffer<Index> Points; ///< 2 an edge: indices of mesh points, ascending
  Buffer<int> CurveId;  ///< ascending, from 1, over all ranks
};

/// The points where curves meet or end. Each is on one rank alone.
struct VertexPoints
{
  Buffer<Index> Points; ///< indices of mesh points, ascending
  Buffer<int> VertexId; ///< ascending, from 1, over all ranks
};

struct Mesh
{
  int Corners = 8;               ///< of an element: 8 hexes, 4 tets
  IdScheme Ids = HexIds;         ///< of points and elements
  Buffer<double> Points;         ///< xyz a point, length units of the grid
  Buffer<Index> PointIds;        ///< global, from 1, ascending
  Buffer<int> GeometryDimension; ///< of each point: 3 volume, 2 surface, 1 curve, 0 vertex
  Buffer<int> GeometryId;        ///< from 1 within its dimension; in volumes the fragment
  Buffer<Index> Elements;        ///< point indices, Corners an element, VTK order
  Buffer<Index> ElementIds;      ///< global, from 1, ascending
  Buffer<int> Material;          ///< of each element; 0 void
  Buffer<int> Fragment; ///< of each element: face-connected piece, numbered from 1 over all ranks
  Buffer<float> ScaledJacobian; ///< verdict's, of each element; empty unless asked for
  SurfaceFacets Surfaces;
  /// The facets from the elements' point of view, ascending by element and side: one for each element of this rank at a facet, whichever
  /// rank owns the facet.
  std::vector<MeshFacet> Facets;
  CurveEdges Curves;
  VertexPoints Vertices;
  GeometryTables Tables;        ///< of all ranks
  std::vector<Index> RowOffset; ///< of hexes of the grid's own cells: the first of each row of
                                ///< CartesianGrid::HexBox (x fastest), and the end
  Index WholeCells = 0; ///< of the elements, from the first one on: cells of the grid, as they are
  std::shared_ptr<const RefinedGrid> Levels; ///< which cells of the grid they are; never null

  int CornersOfFacet() const { return this->Corners == 8 ? 4 : 3; }

  /// Makes room for points and their ids, and for elements, their ids and materials.
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
  /// points: in VTK order.
  template <class ElementPoints>
  void SetElement(Index element, const ElementPoints& points, Index id, int material)
  {
    std::copy(points.begin(), points.end(), this->Elements.data() + this->Corners * element);
    this->ElementIds[element] = id;
    this->Material[element] = material;
  }
};

/// The grid node that owns a point, from its id. Tets: the node of the block in which it starts.
Index3 NodeOfPoint(const CartesianGrid& grid, const Mesh& mesh, Index id);
/// The cells of the grid that an element was made of, from its id: one, or those that a coarser cell holds. A tet stands around
/// a face of the grid: the cell above that face, on an upper side of the domain the one below. TetGen's tets know none.
IndexBox CellsOfElement(const CartesianGrid& grid, const Mesh& mesh, Index id);
/// The lowest of them.
Index3 CellOfElement(const CartesianGrid& grid, const Mesh& mesh, Index id);

/// Throws InputError on all ranks when there are more points than 32 bits number on any. Collective.
void CheckNumberOfPoints(Index points, Ranks& ranks);

} // namespace vfm
