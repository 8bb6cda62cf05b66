/**
 * A mesh of hexahedra or tetrahedra as VTK data. The arrays of the mesh are adopted, not copied; they are empty
 * afterwards.
 */
#pragma once

#include "ImageFrame.h"
#include "InputFields.h"
#include "Mesh/Mesh.h"

class vtkDataObject;
class vtkPolyData;
class vtkTable;
class vtkUnstructuredGrid;

namespace vfm
{

/// The output ports of the filters.
struct MeshOutputs
{
  vtkUnstructuredGrid* Mesh;
  vtkPolyData *Surfaces, *Curves, *Vertices;
  vtkTable* Materials;
};

/// Fills them but Materials.
/// Mesh: cell data MaterialId, FragmentId, GlobalCellIds, ScaledJacobian (if computed); point data
/// GlobalPointIds, GeometryDimension, GeometryId; field data SurfaceParts and EdgeFacets where there are smooth sides.
/// Surfaces: quads or triangles with cell data SurfaceId, MaterialPair, DomainSide; field data SurfaceVolumes, SurfaceMaterials (two of
/// each surface), SurfaceSides, SurfaceParts, SurfaceAreas, SurfaceCentroids and SurfaceNormals (three of each), VolumeSurfaces (pairs).
/// Curves: lines of two points with cell data CurveId; field data CurveEnds, SurfaceCurves (pairs).
/// Vertices: with cell data VertexId; field data CurveVertices (pairs).
/// All three have their own points, with GlobalPointIds; field data as in GeometryTables.
void SetMeshOutput(Mesh& mesh, const Materials& table, const MeshOutputs& outputs);

/// Field data DomainBounds: x from, to, y from, to, z from, to; nodes on a side of the domain have the very coordinate. Of turned images these
/// are bounds in their own axes, and DomainFrame has twelve numbers: the matrix A, row by row, and the origin o. A point u in those axes stands
/// at o + A (u - o).
void SetDomainOutput(const CartesianGrid& grid, const ImageFrame& frame, vtkDataObject* output);

} // namespace vfm
