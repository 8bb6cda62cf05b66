/**
 * What the pipelines of hexahedra and tetrahedra share.
 */
#pragma once

#include "Base/Options.h"
#include "Fractions/FractionField.h"
#include "Interface/SurfaceTargets.h"
#include "Labels/Labels.h"
#include "Mesh/Facet.h"
#include "Mesh/FeatureKind.h"
#include "Mesh/Mesh.h"
#include "Mesh/StageClock.h"
#include "Smoothing/ActiveMesh.h"

namespace vfm
{

/// What a mesh is made from, and what all stages use.
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

/// Throws InputError when an option is out of range.
void CheckOptions(const MeshOptions& options);

/// Changes labels until a valid mesh can be made from them. Collective.
void Resolve(MeshJob& job, LabelArray& labels);

/// If the options ask for it, finds the edges of interfaces and draws the attached points there to them. interface: that of the finest grid.
/// Returns the kinds of all points of the active mesh. Collective.
std::vector<FeatureKind> AttachToFeatures(MeshJob& job, const Interface& interface,
  const std::vector<Facet>& facets, const Mesh& mesh, SurfaceTargets& targets, ActiveMesh& active);

/// Families and hexes of each level, over all ranks; mesh: the owned hexes or tets; asked: LevelHexes::Asked. Collective.
void ReportLevels(
  const Mesh& mesh, const std::vector<Index>& requested, Ranks& ranks, MeshReport& report);

/// Collective.
void MeasureQuality(MeshJob& job, Mesh& mesh);

} // namespace vfm
