/**
 * Pipeline: data and stages that the pipelines of hexahedra and tetrahedra have in common.
 */
#pragma once

#include "Base/Options.h"
#include "Elements/Facet.h"
#include "Elements/FeatureKind.h"
#include "Elements/Mesh.h"
#include "Elements/StageClock.h"
#include "Fractions/FractionField.h"
#include "Interface/SurfaceTargets.h"
#include "Labels/NarrowVoid.h"
#include "Smoothing/ActiveMesh.h"

namespace vfm
{

/// Input of a mesh and data that all stages use. The referenced objects must outlive the job.
struct MeshJob
{
  const CartesianGrid& Grid;
  const FractionField& Fractions;
  const MeshOptions& Options;
  Runtime& Run;
  MeshReport& Report;
  StageClock Clock{ Run, Report };
  const Partition Parts{ Grid, Run.Group() };
};

/// Checks the options of the pipelines.
/// @throws InputError  if an option is out of range
void CheckOptions(const MeshOptions& options);

/// Changes labels until a valid mesh can be made from them (ResolveLabels.h).
/// @param keepsSeam  ResolveLabels
/// @pre Collective.
void Resolve(MeshJob& job, LabelArray& labels, bool keepsSeam);

/// Fills MeshReport::NarrowVoidCells.
/// @pre Collective.
void ReportNarrowVoid(const NarrowVoid& narrow, Ranks& ranks, MeshReport& report);

/// Finds the edges of interfaces, if the options request it, and attracts the
/// attached points to them. Refines the targets of curved elements (RefineTargets.h).
/// @param interface  interface of the finest grid
/// @param[in,out] targets,active  targets and attached points; points near edges get new targets
/// @return kind of every point of the active mesh
/// @pre Collective.
std::vector<FeatureKind> AttachToFeatures(MeshJob& job, const Interface& interface,
  const std::vector<Facet>& facets, const Mesh& mesh, SurfaceTargets& targets, ActiveMesh& active);

/// Returns whether mid nodes of interfaces leave the middles of edges.
inline bool HasCurvedEdges(const MeshSettings& options)
{
  return options.Order != ElementOrder::Linear && MovesPoints(options) &&
    KindOfTargets(options) == SurfaceTargets::Kind::Quadrics;
}

/// Returns Improvement::MeasureBulges, which refers to the arguments.
/// @param facets  all facets of the mesh; the owned ones are in the active mesh
std::function<std::vector<double>()> BulgesOf(MeshJob& job, const std::vector<Facet>& facets,
  const Mesh& mesh, const SurfaceTargets& targets, const ActiveMesh& active);

/// Fills Mesh::Pulls, if the options request curved elements.
void SetPulls(MeshJob& job, const std::vector<Facet>& facets, const SurfaceTargets& targets,
  const ActiveMesh& active, Mesh& mesh);

/// Fills MeshReport::Levels and TransitionCells: the families and hexes of each
/// level over all ranks.
/// @param mesh  mesh with owned elements only
/// @param requested  LevelHexes::RequestedFamilies
/// @pre Collective.
void ReportLevels(
  const Mesh& mesh, const std::vector<Index>& requested, Ranks& ranks, MeshReport& report);

/// Measures the quality of elements, if the options request it, and counts the
/// elements per material.
/// @pre Collective.
void MeasureQuality(MeshJob& job, Mesh& mesh);

} // namespace vfm
