/**
 * MeshFields: what was measured while a mesh was made, and what bounds what in it, as arrays.
 */
#pragma once

#include "Base/Options.h"
#include "Input/FieldArray.h"
#include "Input/ImageFrame.h"
#include "Input/InputFields.h"
#include "Mesh/Mesh.h"
#include "Mesh/MeshReport.h"

namespace vfm
{

using FieldArrays = std::vector<FieldArray>;

/// MaterialNames, MaterialIds, TargetVolume, MeshVolume, VolumeError (of each material, void
/// only when meshed; the error is MeshVolume / TargetVolume - 1, 0 of a material that the input has nowhere), FragmentTargetVolume
/// (of fragments 1, 2, ...), NormalisedCells, ClippedCells, RemovedRegions, RemovedCells, ChosenCells, FlippedCells,
/// ResolveRounds, NumberOfFragments, NumberOfSurfaces, NumberOfCurves, NumberOfVertices, EdgePoints and CornerPoints with SharpEdges, and MinimumScaledJacobian,
/// MeanScaledJacobian if computed.
/// Of tetrahedra also RefusedParts, and MinimumDihedralAngle, MaximumDihedralAngle, DihedralAngles if computed.
/// mesh: tells the kind of its elements, its arrays may be gone.
FieldArrays ListReport(const Mesh& mesh, const MeshReport& report, const Materials& table,
  const MeshOptions& options, const CorrectedCells& corrected);

/// Columns with a row a material, void only when meshed: Name, MaterialId, TargetVolume, MeshVolume (length units cubed), VolumeError,
/// Elements, Fragments, and MinimumScaledJacobian, MeanScaledJacobian if computed (0 without an element).
FieldArrays ListMaterials(
  const MeshReport& report, const Materials& table, const MeshOptions& options);

/// SurfaceParts and EdgeFacets, which tell the surface of a face from its points; none unless interfaces have several.
FieldArrays ListSides(const GeometryTables& tables);

/// SurfaceVolumes, SurfaceMaterials (two of each surface), SurfaceSides, SurfaceParts, SurfaceAreas, SurfaceCentroids and SurfaceNormals (three
/// of each), VolumeSurfaces (pairs).
FieldArrays ListSurfaces(const GeometryTables& tables);
/// CurveEnds, SurfaceCurves (pairs).
FieldArrays ListCurves(const GeometryTables& tables);
/// CurveVertices (pairs).
FieldArrays ListVertices(const GeometryTables& tables);

/// DomainBounds: x from, to, y from, to, z from, to; nodes on a side of the domain have the very coordinate. Of turned images these
/// are bounds in their own axes, and DomainFrame has twelve numbers: the matrix A, row by row, and the origin o. A point u in those axes stands
/// at o + A (u - o).
FieldArrays ListDomain(const CartesianGrid& grid, const ImageFrame& frame);

/// A sentence with the names and ids of the materials of the input that have no element; "" where all have some.
std::string DescribeLostMaterials(const MeshReport& report, const Materials& table);

} // namespace vfm
