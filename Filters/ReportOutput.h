/**
 * What was measured while a mesh was made, as VTK data.
 */
#pragma once

#include "Base/Options.h"
#include "InputFields.h"
#include "Mesh/Mesh.h"
#include "Mesh/MeshReport.h"

class vtkDataObject;
class vtkTable;

namespace vfm
{

/// Field data, hidden from lists of arrays: MaterialNames, MaterialIds, TargetVolume, MeshVolume, VolumeError (of each material, void
/// only when meshed; the error is MeshVolume / TargetVolume - 1, 0 of a material that the input has nowhere), FragmentTargetVolume
/// (of fragments 1, 2, ...), NormalisedCells, ClippedCells, RemovedRegions, RemovedCells, ChosenCells, FlippedCells,
/// ResolveRounds, NumberOfFragments, NumberOfSurfaces, NumberOfCurves, NumberOfVertices, EdgePoints and CornerPoints with SharpEdges, and MinimumScaledJacobian,
/// MeanScaledJacobian if computed.
/// Of tetrahedra also RefusedParts, and MinimumDihedralAngle, MaximumDihedralAngle, DihedralAngles if computed.
/// mesh: tells the kind of its elements, its arrays may be gone.
void SetReportOutput(const Mesh& mesh, const MeshReport& report, const Materials& table,
  const MeshOptions& options, const MendedCells& mended, vtkDataObject* output);

/// A row a material, void only when meshed: Name, MaterialId, TargetVolume, MeshVolume (length units cubed), VolumeError, Elements,
/// Fragments, and MinimumScaledJacobian, MeanScaledJacobian if computed (0 without an element).
void SetMaterialTable(
  const MeshReport& report, const Materials& table, const MeshOptions& options, vtkTable* output);

/// A sentence with the names and ids of the materials of the input that have no element; "" where all have some.
std::string DescribeLostMaterials(const MeshReport& report, const Materials& table);

} // namespace vfm
