/**
 * Volumes of fragments: what the fractions ask for, what the mesh has, and the shift of the interfaces
 * that makes them meet.
 *
 * Sums run in integers over all ranks, so they depend neither on the order nor on the ranks. Every rank holds the
 * volumes of all fragments and the areas of all pairs of fragments. Volumes are in grid coordinates
 * (Interface.h): one mean cell is 1.
 */
#pragma once

#include "Base/PairSums.h"
#include "Base/Runtime.h"
#include "Labels/Fragments.h"
#include "Smoothing/ActiveMesh.h"

#include <functional>

namespace vfm
{

/// Says to which fragment the material in a cell belongs.
class FragmentLocator
{
public:
  virtual ~FragmentLocator() = default;
  /// Calls body(first cell, last cell + 1, fragment) for row (j, k) of HexBox in order; 0 where not meshed.
  using Body = std::function<void(Index, Index, int)>;
  virtual void ForRuns(Index j, Index k, const Body& body) const = 0;
  /// The fragment of a material near a cell whose own fragment has another; 0: none is near.
  virtual int FindNear(const Index3& cell, int material) const = 0;
};

/// The first fragment > 0 that fragmentOf gives for the nearest of the 27 cells around a cell and in HexBox; 0: none.
int FindNearestCell(const CartesianGrid& grid, const Index3& cell,
  const std::function<int(const Index3&)>& fragmentOf);

class FragmentVolumes
{
  static constexpr double LargeFragment = 64.0; // cells

public:
  /// materials: of each fragment, [0] unused. Collective, like Measure.
  FragmentVolumes(const CartesianGrid& grid, const FractionField& fractions,
    std::vector<int> materials, const FragmentLocator& locator, Runtime& runtime);

  /// Says what the mesh has at the start, by fragment over all ranks. Without it: the volumes of the cells.
  void SetStart(std::vector<double> volumes) { this->StartVolumes = std::move(volumes); }

  /// Measures the mesh: the start and what its facets have swept. Without it, volumes are those of the start.
  void Measure(const ActiveMesh& mesh);

  /// The shift of every attachment (grid coordinates) that makes up for what the last measurement lacks: solves
  ///   sum_g A_fg (mu_f - mu_g) = target_f - volume_f
  /// with the areas A of the interfaces, mu = 0 outside; an interface shifts by mu_f - mu_g.
  std::vector<double> FindShifts(const ActiveMesh& mesh) const;

  /// Whether a fragment's target is less than 64 cells. 0, outside, is not small.
  bool IsSmall(int fragment) const
  {
    return fragment > 0 && this->Targets[fragment] < LargeFragment;
  }

  /// Largest |volume - target| / target of a material, and of a fragment that is not small.
  double WorstError() const;
  /// The same of the small fragments.
  double WorstSmallError() const;

  /// From now on, shifts leave the small fragments that are off by more than a relative error as they are, and give what they lack to
  /// the other fragments of their material, in proportion to their targets. Whether there were some.
  bool ExcludeSmall(double error);

  /// Per material from 0, in cells of mean size. Targets count every cell, also where no cell holds the label.
  std::vector<double> MaterialTargets() const { return this->TotalOfMaterial; }
  std::vector<double> MaterialVolumes() const;
  /// How many fragments each material has.
  std::vector<Index> MaterialFragments() const;
  /// By fragment, [0] unused, in cells of mean size: its cells' fractions, and its share of those near no fragment.
  const std::vector<double>& FragmentTargets() const { return this->Targets; }

private:
  void ShareOrphans();
  std::vector<double> FindPotentials() const;
  double VolumeOf(int fragment) const
  {
    return this->StartVolumes[fragment] + this->Swept[fragment];
  }
  double ErrorOf(int fragment) const;
  double WorstOf(bool small) const;

  const std::vector<int> Materials; // of each fragment
  Runtime& Run;
  std::vector<double> Targets;         // by fragment, orphans shared out
  std::vector<double> Aims;            // the same, what is given up shared out too
  std::vector<double> StartVolumes;    // by fragment
  std::vector<double> Swept;           // by fragment, since the start
  std::vector<PairSum> Areas;          // of the interfaces of two fragments
  std::vector<double> TotalOfMaterial; // from the fractions
};

} // namespace vfm
