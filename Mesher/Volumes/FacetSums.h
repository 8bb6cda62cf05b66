/**
 * FacetSums: the volumes that the facets between fragments have swept since the start of the mesh,
 * and their areas, summed over the facets of this rank.
 *
 * Sums are exact, so they can be kept by runs of facets: only runs with a point that has moved are
 * summed again. The result has the same bits as a new sum over all facets.
 */
#pragma once

#include "Base/PairSums.h"
#include "Base/Runtime.h"
#include "Smoothing/ActiveMesh.h"

namespace vfm
{

/// Sums of the facets on one rank, by fragment and by pair of fragments.
class FacetSums
{
public:
  /// Sums all facets.
  /// @param fragments  number of fragments, with the outside
  void Start(const ActiveMesh& mesh, std::size_t fragments, Runtime& runtime);
  /// Sums the runs with points that have moved again.
  /// @param moved  whether each point may have moved since the last call
  /// @pre The facets are the same as in Start.
  void Update(const ActiveMesh& mesh, const std::vector<unsigned char>& moved, Runtime& runtime);

  /// Returns the volume that each fragment has gained, in grid coordinates.
  const std::vector<ExactSum>& Swept() const { return this->TheSwept; }
  const PairSumMap& Areas() const { return this->TheAreas; }

private:
  using Flags = std::vector<unsigned char>;
  /// Consecutive facets between the same fragments.
  struct FacetRun
  {
    Index First, End;
    std::array<int, 2> Fragments;
    std::array<int, 2> Points; // smallest and largest point of the facets
    ExactSum Swept, Area;
  };

  void FindRuns(const ActiveMesh& mesh);
  void Replace(const FacetRun& from, const FacetRun& to);
  static bool HasMoved(const ActiveMesh& mesh, const FacetRun& run, const Flags& moved);
  static void Sum(const ActiveMesh& mesh, FacetRun& run);

  std::vector<FacetRun> Runs;
  std::vector<ExactSum> TheSwept;
  PairSumMap TheAreas;
};

} // namespace vfm
