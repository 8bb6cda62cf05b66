/**
 * The hexahedral mesh as VTK data. The arrays of the mesh are adopted, not copied; they are empty
 * afterwards.
 */
#pragma once

#include "HexMesh.h"
#include "InputFields.h"

class vtkDataObject;
class vtkPolyData;
class vtkUnstructuredGrid;

namespace vfm
{

/// Fills the output ports of the filter.
/// mesh: cell data MaterialId, FragmentId, GlobalCellIds, ScaledJacobian (if computed); point data
/// GlobalPointIds, GeometryDimension, GeometryId.
/// surfaces: quads with cell data SurfaceId, MaterialPair, DomainSide and point data GlobalPointIds.
void SetHexMeshOutput(
  HexMesh& hexes, const Materials& table, vtkUnstructuredGrid* mesh, vtkPolyData* surfaces);

/// Field data: MaterialNames, MaterialIds, TargetVolume, MeshVolume (of each material, void only when
/// meshed), NormalisedCells, FlippedCells, ResolveRounds, NumberOfFragments, NumberOfSurfaces,
/// NumberOfCurves, NumberOfVertices, and MinimumScaledJacobian, MeanScaledJacobian if computed.
void SetReportOutput(const HexMeshReport& report, const Materials& table,
  const HexMeshOptions& options, Index normalisedCells, vtkDataObject* output);

} // namespace vfm
