/**
 * MeshFields: measurements of a mesh, and the relations of its surfaces, curves and vertices,
 * as arrays.
 */
#pragma once

#include "Base/Options.h"
#include "Elements/Mesh.h"
#include "Elements/MeshReport.h"
#include "Input/FieldArray.h"
#include "Input/ImageFrame.h"
#include "Input/InputFields.h"

namespace vfm
{

struct WideReport;

using FieldArrays = std::vector<FieldArray>;

/// Lists the report of a mesh.
/// - One value per material, void only if meshed: MaterialNames, MaterialIds, TargetVolume,
///   MeshVolume, VolumeError (MeshVolume / TargetVolume - 1; 0 if the input has no such material),
///   LostCells and GainedCells (cells or leaves that changed their material)
/// - The given fields of fragments
/// - Counts: NormalisedCells, ClippedCells, RemovedRegions, RemovedCells, ChosenCells,
///   FlippedCells, ResolveRounds, NarrowVoidCells, NumberOfFragments, NumberOfSurfaces,
///   NumberOfCurves, NumberOfVertices; EdgePoints and CornerPoints with SharpEdges; RefusedParts of
///   tetrahedra
/// - ComputeQuality adds MinimumScaledJacobian, MeanScaledJacobian; MinimumDihedralAngle,
///   MaximumDihedralAngle and DihedralAngles of tetrahedra
/// - Several levels add RefinedCells, CellsAddedForBalance, CellsAddedForValidity, LevelCells,
///   TransitionCells
/// @param mesh determines the kind of elements; its arrays may be empty
/// @param targets fields of fragments (ListFragmentTargets)
FieldArrays ListReport(const Mesh& mesh, const MeshReport& report, const Materials& table,
  const MeshOptions& options, const CorrectedCells& corrected, const FieldArrays& targets);

/// Lists columns with one row per material, void only if meshed: Name, MaterialId, TargetVolume,
/// MeshVolume (length units cubed), VolumeError, LostCells and GainedCells (cells that changed
/// their material), Elements and Fragments. ComputeQuality adds MinimumScaledJacobian and
/// MeanScaledJacobian, 0 for a material without elements.
FieldArrays ListMaterials(
  const MeshReport& report, const Materials& table, const MeshOptions& options);

/// Lists SurfaceParts and EdgeFacets, from which MeshFacets.h finds the surface of a face, and
/// PatchNames (MeshSets.h) if there are any; nothing if no interface has several sides. If ranks do
/// not have all rows: SurfaceIds, the numbers of the smooth sides of this rank, their SurfaceParts
/// and EdgeFacets.
FieldArrays ListSides(const GeometryTables& tables);

/// Returns the rows of the field EdgeFacets, or none.
std::vector<std::array<Index, 5>> ReadEdgeFacets(const FieldArrays& fields);

/// Lists SurfaceVolumes and SurfaceMaterials (two per surface), SurfaceSides, SurfaceParts,
/// SurfaceAreas, SurfaceCentroids and SurfaceNormals (three per surface), VolumeSurfaces (pairs);
/// and PatchNames if there are any. If ranks do not have all rows, SurfaceIds are the numbers of
/// the rows of this rank.
FieldArrays ListSurfaces(const GeometryTables& tables);
/// Lists CurveEnds and SurfaceCurves (pairs); and CurveIds, the numbers of the rows of this rank,
/// if ranks do not have all.
FieldArrays ListCurves(const GeometryTables& tables);
/// Lists CurveVertices (pairs).
FieldArrays ListVertices(const GeometryTables& tables);

/// Lists the domain. DomainBounds: x min, max, y min, max, z min, max; nodes on a side of the
/// domain have exactly this coordinate. Bounds of a rotated image are in image axes.
/// DomainFrame then has the matrix A, row-major, and the origin o: x = o + A (u - o) for a
/// point u in image axes. PeriodLengths of a periodic mesh: lengths along x, y, z after which the
/// domain repeats; 0: it does not.
FieldArrays ListDomain(
  const CartesianGrid& grid, const ImageFrame& frame, const std::array<bool, 3>& isPeriodic = {});

/// Lists columns with one row per material, void only if meshed: InputCells and NewCells, the cells
/// of each material before and after cells were replaced; nothing if they were not.
FieldArrays ListReplaced(const WideReport& wide, bool meshVoid);

/// Moves fields to the end of others.
void AppendFields(FieldArrays more, FieldArrays& to);

/// Replaces fields by newer ones of the same names.
void ReplaceFields(const FieldArrays& newer, FieldArrays& fields);

/// Returns a sentence with the materials of the input that have no element; "" if all
/// have elements.
std::string DescribeLostMaterials(const MeshReport& report, const Materials& table);

/// Returns sentences with the materials whose elements miss their volume by more than 1 %, those
/// with the largest missing volumes first, and with what helps; "" if there are none. Does not name
/// materials without elements.
/// @param areLabels  whether the input was labels, not fractions
std::string DescribeInexactMaterials(
  const MeshReport& report, const Materials& table, bool areLabels);

/// Returns a sentence with the materials that miss their volume by more than 1 % in cells that
/// replace those of the input, and the width that keeps them; "" if there are none.
/// @param areExact  false: the mesh does not conserve volumes; names only materials without
/// elements
std::string DescribeWideLosses(
  const MeshReport& report, const Materials& table, const WideReport& wide, bool areExact);

/// Returns sentences with the materials of which more than 5 % is displaced (DisplacedVolume.h), in
/// cells that replace others more than 10 %, those with the largest displaced volumes first, and
/// with what helps; "" if there are none or it was not measured. Does not name materials without
/// elements.
/// @param hasParticles  whether material without elements became particles
std::string DescribeDisplacedMaterials(
  const MeshReport& report, const Materials& table, const WideReport& wide, bool hasParticles);

} // namespace vfm
