/**
 * A mesh of hexahedra or tetrahedra as VTK data. The arrays of the mesh are adopted, not copied;
 * they are empty afterwards.
 */
#pragma once

#include "Elements/Mesh.h"
#include "Report/Sets/SplitFaces.h"

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
  vtkUnstructuredGrid* Cohesive;
  vtkPolyData* Particles;
};

/// Fills all outputs except Materials and Particles.
/// - Mesh: cell data MaterialId, FragmentId, GlobalCellIds, ScaledJacobian (if computed); point
///   data GlobalPointIds, GeometryDimension, GeometryId
/// - Surfaces: quads or triangles with cell data SurfaceId, MaterialPair, DomainSide
/// - Curves: lines of two points with cell data CurveId
/// - Vertices: cell data VertexId
/// - Cohesive: hexahedra or wedges with cell data MaterialPair, GlobalCellIds
///
/// All outputs except Mesh have their own points, with GlobalPointIds. Surfaces, Curves and
/// Vertices have the ids before interfaces were split, and the field data of ListSurfaces,
/// ListCurves and ListVertices, of all ranks or of this one (GatherTables in ReportRun.h).
/// @param cohesive  cohesive elements of this rank
void SetMeshOutput(Mesh& mesh, const CohesiveElements& cohesive, const MeshOutputs& outputs);

///@{ Fill Mesh and Cohesive alone. Cohesive elements are first, because the mesh is empty after.
void SetElementOutput(Mesh& mesh, vtkUnstructuredGrid* output);
void SetCohesiveOutput(
  const Mesh& mesh, const CohesiveElements& elements, vtkUnstructuredGrid* output);
///@}

} // namespace vfm
