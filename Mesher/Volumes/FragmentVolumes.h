/**
 * FragmentVolumes: the volumes of fragments in the fractions (targets) and in the mesh, and the
 * shifts of the interfaces that make them equal.
 *
 * Sums are exact (ExactSum), so they depend on neither their order nor the number of ranks. A rank
 * holds the volumes of the fragments that it touches (FragmentShare) and the interface areas of its
 * pairs of fragments, with the parts of all ranks. Volumes are in grid coordinates (Interface.h),
 * where the volume of a mean cell is 1.
 *
 * Some fragments resist: the barrier, or a lack of cells, keeps them far from their targets. The
 * shifts of all fragments are coupled, so a fragment that resists would pull its neighbours off
 * their targets too. Therefore the system assumes that it keeps its volume, and the other fragments
 * of its material take over what it lacks. It is pushed towards its target apart from the system,
 * unless it is hopelessly far from it.
 */
#pragma once

#include "Elements/FarMatter.h"
#include "Elements/MeshReport.h"
#include "Labels/FragmentShare.h"
#include "Volumes/FacetSums.h"
#include "Volumes/IslandSystem.h"

#include <functional>
#include <memory>

namespace vfm
{

/// Interface that finds the fragment of the material in a cell. Called by several threads at once.
class FragmentLocator
{
public:
  virtual ~FragmentLocator() = default;
  /// Calls body(first cell, last cell + 1, fragment) for the runs of row (j, k) of HexBox in order;
  /// the fragment is 0 where cells are not meshed.
  using Body = std::function<void(Index, Index, int)>;
  virtual void ForRuns(Index j, Index k, const Body& body) const = 0;
  /// Returns the fragment of a material near a cell of another fragment, or 0.
  virtual int FindNear(const Index3& cell, int material) const = 0;
};

/// Returns the fragment of the nearest cell whose fragmentOf is positive, or 0. Candidates are the
/// 27 cells around a cell that lie in HexBox; the first of equally near ones counts.
int FindNearestCell(const CartesianGrid& grid, const Index3& cell,
  const std::function<int(const Index3&)>& fragmentOf);

/// How the volume of a fragment is corrected.
struct VolumeRule
{
  double Tolerance; ///< relative error that is not corrected
  /// Largest factor by which the fragment is asked for more than its error, if it changed by less
  /// than the last time it was asked.
  double LargestFactor;
};

/// How the volumes of fragments are corrected.
struct VolumeRules
{
  VolumeRule Large, Small; ///< of fragments that are not small, and of small ones
  /// Whether fragments that resist are pushed towards their targets, and fragments that hardly
  /// follow are asked for the largest factor.
  bool Insists;
};

/// Target and current volumes of the fragments of this rank, equal on all their ranks. Fragments
/// have the numbers of this rank. Refers to the runtime.
class FragmentVolumes
{
  static constexpr double LargeFragment = 64.0; // cells

public:
  /// Finds the target volumes of all fragments.
  /// @param share  the fragments of this rank
  /// @param locator  is used only here
  /// @param leavesFar  whether the targets do not count far material (FarMatter.h); else all
  ///   fragments of the material share it. Void is always shared.
  /// @pre Collective.
  FragmentVolumes(const CartesianGrid& grid, const FractionField& fractions, FragmentShare share,
    const FragmentLocator& locator, bool leavesFar, Runtime& runtime);

  /// Returns the fragments of this rank.
  const FragmentShare& Share() const { return *this->Fragments; }

  /// Returns the far material of the owned cells, ascending by cell and material; none without
  /// leavesFar. May be called once.
  std::vector<FarMatter> TakeFar() { return std::move(this->Far); }

  /// Sets the initial volumes of the mesh over all ranks, by fragment of this rank. Without this
  /// call they are the volumes of the cells.
  void SetStart(std::vector<double> volumes) { this->StartVolumes = std::move(volumes); }

  /// Measures the mesh: the initial volumes plus the volumes that its facets have swept. Before the
  /// first call, volumes are the initial ones.
  /// @pre Collective.
  void Measure(const ActiveMesh& mesh);
  /// Measures the mesh again; equal to Measure(mesh).
  /// @param moved  whether each point may have moved since the last measurement
  /// @pre Measure(mesh) was called, and the facets are the same. Collective.
  void Measure(const ActiveMesh& mesh, const std::vector<unsigned char>& moved);

  /// Sets the volume that each fragment gains because its elements are curved; 0 without this call.
  /// @pre Collective.
  void SetBulges(std::vector<double> bulges);

  /// Returns the shift of each attachment, in grid coordinates, that corrects the errors of the
  /// last measurement. Solves
  ///
  ///   sum_g A_fg (mu_f - mu_g) = factor_f (aim_f - volume_f)
  ///
  /// with the areas A of the interfaces and mu = 0 outside. An interface shifts by mu_f - mu_g. The
  /// aim is the target, or the volume of a fragment that resists or is within its tolerance. The
  /// factor is the inverse of the part of the last request by which the fragment changed, from 1 to
  /// the largest factor. Without Insists it is 1 where that part is smaller. A push adds factor_f
  /// (target_f - volume_f) / sum_g A_fg to mu of a resisting fragment whose error is at most 50 %.
  /// @pre Collective.
  std::vector<double> FindShifts(const ActiveMesh& mesh, const VolumeRules& rules);
  /// Sets all factors of the next call of FindShifts to 1. Measure(mesh) does so too.
  void ForgetRequests() { this->Requests.assign(this->Targets.size(), {}); }

  /// Returns whether the target of a fragment is below 64 cells; false for 0, the outside.
  bool IsSmall(int fragment) const
  {
    return fragment > 0 && this->Targets[fragment] < LargeFragment;
  }

  /// Returns the largest |volume - aim| / aim of all materials and of all fragments of all ranks
  /// that are not small.
  /// @pre Collective.
  double WorstError() const;
  /// Returns the largest |volume - aim| / aim of all fragments of all ranks.
  /// @pre Collective.
  double WorstFragmentError() const;
  /// Returns whether FindShifts may push any fragment of any rank that resists.
  /// @pre Collective.
  bool HasPushed() const;

  /// Returns whether the volume of each fragment is off its target by more than a relative error.
  std::vector<unsigned char> FindOff(double error) const;
  /// Returns the sum of |volume - target| of flagged fragments of all ranks.
  /// @pre Collective.
  double SumErrors(const std::vector<unsigned char>& fragments) const;
  /// Ends the marks of flagged fragments as resisting.
  /// @pre Collective.
  void ForgetResisting(const std::vector<unsigned char>& fragments);

  /// Marks the fragments with a relative error above `error` as resisting. The other fragments of
  /// their material take over the missing volume in proportion to their targets, each at most 10 %.
  /// The marks of fragments that reach their targets within this error end.
  /// @pre Collective.
  void MarkResisting(double error);

  /// Returns by which factor the lengths of each small fragment must change to give it its aim, or
  /// its target if it resists; 1 for fragments that are off by at most this relative error, for
  /// those that are not small, and for the outside, [0].
  std::vector<double> FindScales(double error) const;

  /// Return the volume per material from 0 over all ranks, in mean cells. Targets include cells
  /// without an element of the material nearby, unless these are left.
  /// @pre Collective.
  std::vector<double> MaterialTargets() const { return this->TotalOfMaterial; }
  std::vector<double> MaterialVolumes() const;
  /// Returns the number of fragments per material over all ranks.
  /// @pre Collective.
  std::vector<Index> MaterialFragments() const;
  /// Returns the target of each fragment, [0] unused, in mean cells: the fractions in and near its
  /// cells, plus a share of the fractions near no fragment.
  const std::vector<double>& FragmentTargets() const { return this->Targets; }

private:
  /// The last request to a fragment: the change of its volume, 0 if none, and its volume then.
  struct Request
  {
    double Change = 0.0, Volume = 0.0;
  };

  template <class ValueOf>
  std::vector<double> SumByMaterial(const ValueOf& valueOf) const;
  void DistributeOrphans(bool leavesFar);
  void SumFacets();
  void SetAims();
  std::vector<double> FindRequests(const VolumeRules& rules) const;
  double FactorOf(int fragment, double largest, bool insists) const;
  void AddPushes(const std::vector<double>& requests, std::vector<double>& mu) const;
  bool IsPushed(int fragment) const;
  double VolumeOf(int fragment) const
  {
    return this->StartVolumes[fragment] + this->Swept[fragment] +
      (this->Bulges.empty() ? 0.0 : this->Bulges[fragment]);
  }
  double ErrorOf(int fragment) const;

  std::shared_ptr<const FragmentShare> Fragments; // IslandSystem refers to it
  Runtime& Run;
  std::vector<double> Targets;        // target of each fragment
  std::vector<double> Aims;           // volumes that the system requests
  std::vector<unsigned char> Resists; // whether each fragment resists
  double Tolerance = 0.0;             // relative error up to which none resists
  FacetSums Facets;
  std::vector<double> StartVolumes;    // initial volume of each fragment
  std::vector<double> Swept;           // volume that each fragment has gained since then
  std::vector<double> Bulges;          // SetBulges
  std::vector<Request> Requests;       // of each fragment
  IslandSystem System;                 // of the pairs of fragments
  std::vector<PairSum> Areas;          // interface areas of pairs of fragments of this rank
  std::vector<double> TotalOfMaterial; // total volume of each material in the fractions
  std::vector<FarMatter> Far;          // TakeFar
};

/// Writes the volumes of materials and fragments into the report, in length units cubed, and the
/// number of fragments per material.
/// @pre Collective.
void ReportVolumes(const CartesianGrid& grid, const FragmentVolumes& volumes, MeshReport& report);

} // namespace vfm
