/**
 * FragmentWays: the fragments of the elements of each rank, and the ways to the ranks that hold one
 * row per fragment.
 *
 *      rank 0 has fragments 1, 2, 5        rows of 1, 2 at rank 0
 *      rank 1 has fragments 2, 3      ->   rows of 3, 5 at rank 1
 */
#pragma once

#include "Base/ExactSum.h"
#include "Ranks/KeyMerge.h"
#include "Report/MeshData.h"

namespace vfm
{

/// Fragments of this rank's elements. Rows of fragments are in parts: each home has those of a
/// range of ids, which rise with the ranks. A rank only stores fragments of its elements and of its
/// rows.
class FragmentWays
{
public:
  /// @param mesh  with Fragment, ids of at least 1
  /// @param more  further fragments of this rank, in any order
  /// @pre Collective over `ranks`, which must outlive it.
  FragmentWays(const MeshData& mesh, const std::vector<int>& more, Ranks& ranks);

  /// Returns the ids of the fragments of this rank, ascending.
  const std::vector<int>& Ids() const { return this->Own; }
  /// Returns the place in Ids of the fragment of each element.
  const std::vector<int>& PlaceOfElement() const { return this->Places; }
  /// Returns the ids of the fragments whose rows this rank has, ascending.
  const std::vector<int>& HomeIds() const { return this->Ways.HomeKeys(); }
  /// Returns the rank that has the row of a fragment of any rank.
  int HomeOf(int id) const;

  ///@{ Return the values of all ranks combined for each row of this rank.
  /// @param values  `width` values per fragment of this rank
  /// @return `width` values per row of this rank
  /// @pre Collective
  std::vector<ExactSum> Sum(std::vector<ExactSum> values, std::size_t width) const
  {
    return this->Ways.ToHome(
      std::move(values), width, [](ExactSum& a, const ExactSum& b) { a.Add(b); });
  }
  std::vector<Index> Sum(std::vector<Index> values, std::size_t width) const
  {
    return this->Ways.ToHome(std::move(values), width, [](Index& a, Index b) { a += b; });
  }
  std::vector<double> Max(std::vector<double> values, std::size_t width) const
  {
    return this->Ways.ToHome(
      std::move(values), width, [](double& a, double b) { a = std::max(a, b); });
  }
  ///@}

private:
  int Homes;      // number of ranks that can have rows
  Index Last = 0; // largest id of all ranks
  std::vector<int> Own, Places;
  KeyMerge<int> Ways;
};

} // namespace vfm
