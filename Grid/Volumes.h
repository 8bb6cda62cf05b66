/**
 * Volumes of fragments: what the fractions ask for, what the mesh has, and the shift of the interfaces
 * that makes them meet.
 *
 * Sums run in integers over all ranks, so they depend neither on the order nor on the ranks. Every rank holds the
 * volumes of all fragments and the areas of all pairs of fragments. Volumes are in grid coordinates
 * (Interface.h): one mean cell is 1.
 */
#pragma once

#include "ActiveMesh.h"
#include "ExactSum.h"
#include "Fragments.h"
#include "SurfaceTargets.h"

#include <map>

namespace vfm
{

class FragmentVolumes
{
public:
  /// Collective, like Measure.
  FragmentVolumes(const FractionField& fractions, const LabelArray& labels,
    const Interface& interface, const Fragments& fragments, const Partition& partition);

  /// Measures the mesh. Without it, volumes are those of the cells.
  void Measure(const ActiveMesh& mesh);

  /// The shift of every target (grid coordinates) that makes up for what the last measurement lacks: solves
  ///   sum_g A_fg (mu_f - mu_g) = target_f - volume_f
  /// with the areas A of the interfaces, mu = 0 outside; an interface shifts by mu_f - mu_g.
  std::vector<double> FindShifts() const;

  /// Largest |volume - target| / target of a material, and of a fragment of 64 cells or more.
  double WorstError() const;

  /// Per material from 0, in cells of mean size. Targets count every cell, also where no cell holds the label.
  std::vector<double> MaterialTargets() const;
  std::vector<double> MaterialVolumes() const;

private:
  struct Side
  {
    int Lower, Upper; // fragments beside a face; 0 where not meshed, or far from the owned cells
    bool Counts;      // here: one rank counts each face
  };
  struct Area // of the interface of two fragments, the smaller first
  {
    int First, Second;
    ExactSum Value;
  };
  void FindSides();
  void GatherAreas(const std::map<std::pair<int, int>, ExactSum>& areas);
  void AddTargets(const FractionField& fractions, const LabelArray& labels);
  int FragmentNear(const LabelArray& labels, const Index3& cell, int material) const;
  void ShareOrphans();
  double Lack(std::size_t fragment) const;

  const Interface& TheInterface;
  const Fragments& TheFragments;
  const Partition& Parts;
  std::vector<Side> Sides;                       // of every interface face
  std::vector<std::array<int, 2>> PairFragments; // of every target: of its first and second label
  std::vector<double> Targets;                   // by fragment, orphans shared out
  std::vector<double> CellVolumes;               // by fragment
  std::vector<double> Swept;                     // by fragment: mesh minus cells
  std::vector<Area> Areas;                       // sorted
  std::vector<double> TotalOfMaterial;           // from the fractions
};

} // namespace vfm
