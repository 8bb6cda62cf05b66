/**
 * What the pipelines of hexahedra and tetrahedra share.
 */
#pragma once

#include "Creases/Creases.h"
#include "Hex/LabelledGrid.h"
#include "Labels/Labels.h"
#include "Mesh/CreaseKind.h"
#include "Mesh/Facet.h"
#include "Mesh/MeshReport.h"
#include "Smoothing/Smoother.h"
#include "Smoothing/Volumes.h"

#include <chrono>

namespace vfm
{

/// Names the running stage, times it and tells the progress.
class StageClock
{
public:
  StageClock(Runtime& runtime, MeshReport& report) : Run(runtime), Report(report) {}
  ~StageClock() { this->Stop(); }
  void Start(const char* name, double fraction)
  {
    this->Stop();
    this->Report.Stages.push_back({ name, 0.0 });
    this->Begin = std::chrono::steady_clock::now();
    this->Update(fraction);
  }
  void Update(double fraction)
  {
    this->Run.Progress(this->Share * fraction, this->Report.Stages.back().Name);
  }
  /// What part of the whole run the fractions are of, from now on.
  void SetShare(double share) { this->Share = share; }

private:
  void Stop()
  {
    if (!this->Report.Stages.empty())
    {
      this->Report.Stages.back().Seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - this->Begin).count();
    }
  }
  Runtime& Run;
  MeshReport& Report;
  double Share = 1.0;
  std::chrono::steady_clock::time_point Begin;
};

/// What the stages of hexahedra and tetrahedra are given, and those that both have.
class MeshStages
{
public:
  MeshStages(const CartesianGrid& grid, const FractionField& fractions, const MeshOptions& options,
    Runtime& runtime, MeshReport& report) :
    Grid(grid),
    Fractions(fractions),
    Options(options),
    Run(runtime),
    Report(report),
    Clock(runtime, report),
    Parts(grid, runtime.Group())
  {
  }

protected:
  void Resolve(LabelArray& labels);
  void MeasureQuality(Mesh& mesh);
  /// If asked for, finds the edges of interfaces and draws the attached points there to them. interface: that of the finest grid. Returns
  /// the kinds of all points of the active mesh.
  std::vector<CreaseKind> AttachToCreases(const Interface& interface,
    const std::vector<Facet>& facets, const Mesh& mesh, SurfaceTargets& targets,
    ActiveMesh& active);

  const CartesianGrid& Grid;
  const FractionField& Fractions;
  const MeshOptions& Options;
  Runtime& Run;
  MeshReport& Report;
  StageClock Clock;
  const Partition Parts;
};

/// Throws InputError when an option is out of range.
void CheckOptions(const MeshOptions& options);

/// What improves a mesh; all of it outlives the call.
struct Improvement
{
  ActiveMesh& Active;
  const SurfaceTargets& Targets;
  const ElementEnergy& Energy;
  const SmoothingRamp& Ramp;
  FragmentVolumes& Volumes;
  MeshReport& Report; ///< gets what it took
  bool ConserveVolume;
  std::function<void(Smoother&, const SmoothingStage&, int)>
    AfterSweep;                    ///< with the number of the sweep; may be empty
  std::function<void()> AfterRamp; ///< before volumes are measured; may be empty
};

/// Smooths, then moves the interfaces until the volumes of the fragments are those of the fractions. Collective.
void Improve(const Improvement& what, StageClock& clock, Runtime& runtime);

/// The kind of targets that the options ask for.
inline SurfaceTargets::Kind KindOfTargets(const MeshOptions& options)
{
  return options.Method == Smoothing::GeometryBased ? SurfaceTargets::Kind::Facets
                                                    : SurfaceTargets::Kind::Quadrics;
}

/// Where interfaces cross levels: leaves are refined until a valid mesh starts everywhere. Collective. Throws InputError as MakeLevels does.
void LabelLeaves(const CartesianGrid& grid, const FractionField& fractions,
  const MeshOptions& options, const Partition& partition, Runtime& runtime, MeshReport& report,
  LabelledGrid& result);

/// Makes the levels that a plan asks for; adds to it what has to be refined so that a valid mesh starts. interfaces: as in RefinedGrid. hexes: as in
/// CoarseHexes. levels: as they are made so far. Collective. Throws InputError as RefinedGrid and CoarseHexes do.
void MakeLevels(const CartesianGrid& grid, const LabelArray& labels,
  const std::vector<Index>& interfaces, const CoarseHexes::Options& hexes, LevelPlan& plan,
  Runtime& runtime, MeshReport& report, LevelHexes& levels);

/// Adds families to a plan because no valid mesh starts there; whether any rank had some. Collective.
bool AddFamilies(const std::vector<std::vector<Index>>& families, LevelPlan& plan, Ranks& ranks);

/// Families and hexes of each level, over all ranks; mesh: the owned hexes or tets; asked: LevelHexes::Asked. Collective.
void ReportLevels(
  const Mesh& mesh, const std::vector<Index>& asked, Ranks& ranks, MeshReport& report);

/// Volumes per material and fragment in length units of the grid.
void ReportVolumes(const CartesianGrid& grid, const FragmentVolumes& volumes, MeshReport& report);

} // namespace vfm
