/**
 * A mesh of hexahedra or tetrahedra as VTK data. The arrays of the mesh are adopted, not copied;
 * they are empty afterwards.
 */
#pragma once

#include "Mesh/Mesh.h"

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

/// Fills all outputs except Materials.
/// - Mesh: cell data MaterialId, FragmentId, GlobalCellIds, ScaledJacobian (if computed); point
///   data GlobalPointIds, GeometryDimension, GeometryId
/// - Surfaces: quads or triangles with cell data SurfaceId, MaterialPair, DomainSide
/// - Curves: lines of two points with cell data CurveId
/// - Vertices: cell data VertexId
///
/// Surfaces, Curves and Vertices have their own points, with GlobalPointIds, and the field data of
/// ListSurfaces, ListCurves and ListVertices.
void SetMeshOutput(Mesh& mesh, const MeshOutputs& outputs);

} // namespace vfm
