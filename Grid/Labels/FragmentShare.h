/**
 * FragmentShare: the fragments that a rank touches, and sums over the ranks that share them.
 *
 * A rank numbers the fragments that it touches from 1, in the order of their numbers over all
 * ranks. So comparisons of both numbers agree, and arrays by fragment are as long as the rank
 * needs. On a single rank both numbers are equal.
 */
#pragma once

#include "Base/ExactSum.h"
#include "Base/IndexBox.h"
#include "Base/Sorted.h"
#include "Ranks/KeyMerge.h"

namespace vfm
{

/// Fragments of one rank. The ranks must outlive it. Arrays have one entry per fragment of this
/// rank; [0] is the outside.
struct FragmentShare
{
  std::vector<int> Ids{ 0 };                ///< number over all ranks
  std::vector<int> Materials{ 0 };          ///< [0] is unused
  std::vector<unsigned char> IsMine{ 0 };   ///< true on the one rank that counts the fragment
  std::vector<unsigned char> IsShared{ 0 }; ///< whether other ranks touch it
  std::vector<int> Shared;                  ///< numbers on this rank of the shared ones, ascending
  KeyMerge<Index> Ways;                     ///< of the shared ones
  Index Total = 0;                          ///< number of fragments over all ranks
  Ranks* Group = nullptr;

  /// Returns the number of fragments of this rank, with the outside.
  std::size_t Size() const { return this->Ids.size(); }
  /// Returns the number on this rank of a fragment by its number over all ranks, or 0 if this rank
  /// does not touch it.
  int Find(int id) const
  {
    const auto at = FindSorted(this->Ids, id);
    return at < 0 ? 0 : static_cast<int>(at);
  }

  /// Replaces the values of each fragment by their combination over the ranks that share it.
  /// @param values  `width` values per fragment of this rank, trivially copyable; those of [0] stay
  /// @param join  join(a, b) combines value b into a; commutative and associative
  /// @pre Collective.
  template <class T, class Join>
  void Merge(std::vector<T>& values, std::size_t width, const Join& join) const
  {
    std::vector<T> shared;
    shared.reserve(width * this->Shared.size());
    for (int f : this->Shared)
    {
      const auto first = values.begin() + static_cast<std::ptrdiff_t>(width * f);
      shared.insert(shared.end(), first, first + static_cast<std::ptrdiff_t>(width));
    }
    this->Ways.Merge(shared, width, join);
    for (std::size_t s = 0; s < this->Shared.size(); ++s)
    {
      std::copy_n(shared.begin() + static_cast<std::ptrdiff_t>(width * s), width,
        values.begin() + static_cast<std::ptrdiff_t>(width * this->Shared[s]));
    }
  }

  /// Sets the flag of each fragment to whether it is set on any rank.
  /// @pre Collective.
  void Unite(std::vector<unsigned char>& flags) const
  {
    this->Merge(
      flags, 1, [](unsigned char& a, unsigned char b) { a = static_cast<unsigned char>(a | b); });
  }

  /// Returns the values of the sums of each fragment over all ranks. [0] is that of this rank only.
  /// @param sums  `width` sums per fragment of this rank
  /// @pre Collective.
  std::vector<double> Sum(std::vector<ExactSum> sums, std::size_t width = 1) const
  {
    this->Merge(sums, width, [](ExactSum& a, const ExactSum& b) { a.Add(b); });
    return ValuesOf(sums);
  }
};

} // namespace vfm
