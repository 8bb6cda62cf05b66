/**
 * LabelSizes: the numbers of cells of labels, which determine how much a flip of a cell costs small
 * labels.
 */
#pragma once

#include "Labels/Labels.h"

namespace vfm
{

/// Number of cells of each label in the domain, initially and now. It determines how much a flip
/// costs the smaller of both labels.
class LabelSizes
{
public:
  /// @pre Collective.
  LabelSizes(
    const CartesianGrid& grid, const LabelArray& labels, int count, const Partition& partition) :
    First(count, 0), Change(count, 0), Group(&partition.Group())
  {
    partition.ForRows(grid.Owned(),
      [&](Index first, Index last)
      {
        labels.Visit(
          first, last,
          [&](Index begin, Index end, int label) { this->First[label] += end - begin; },
          [&](Index begin, Index end, const int* own)
          { std::for_each(own, own + (end - begin), [&](int label) { ++this->First[label]; }); });
      });
    this->Group->Sum(this->First);
    this->Now = this->First;
    this->HasSmall = std::any_of(this->First.begin(), this->First.end(),
      [](Index cells) { return cells > 0 && cells < SmallLabel; });
  }

  /// Returns the initial size of a label, at most SmallLabel.
  Index CappedSize(int label) const { return std::min<Index>(this->First[label], SmallLabel); }

  bool IsLast(Index cells, int label) const { return this->Now[label] <= cells; }

  /// Returns the factor on the price of a flip of some cells; 1 between large labels. A small label
  /// pays more for the loss of cells if it has at most its initial number, and for a gain if it has
  /// at least that number.
  double Factor(Index cells, int current, int label) const
  {
    const auto partOf = [&](int l)
    { return static_cast<double>(SmallLabel * cells) / static_cast<double>(this->First[l]); };
    return std::max({ 1.0, this->Now[current] <= this->First[current] ? partOf(current) : 0.0,
      this->Now[label] >= this->First[label] ? PriceOfGrowth * partOf(label) : 0.0 });
  }

  /// Counts a flip of this rank.
  void Add(Index cells, int current, int label)
  {
    this->Change[current] -= cells;
    this->Change[label] += cells;
  }
  /// Sums the flips of all ranks.
  /// @pre Collective.
  void Share()
  {
    const std::vector<std::int64_t> change = this->SumChanges();
    std::transform(
      this->Now.begin(), this->Now.end(), change.begin(), this->Now.begin(), std::plus<>());
  }
  /// Returns the labels that have no cell left after the flips of all ranks, ascending, and forgets
  /// these flips.
  /// @pre Collective.
  std::vector<int> FindLost()
  {
    const std::vector<std::int64_t> change = this->SumChanges();
    std::vector<int> lost;
    for (std::size_t label = 0; label < change.size(); ++label)
    {
      if (change[label] < 0 && this->Now[label] + change[label] <= 0)
      {
        lost.push_back(static_cast<int>(label));
      }
    }
    return lost;
  }

private:
  /// Returns the flips of all ranks since the last call; zeros if sizes do not matter.
  std::vector<std::int64_t> SumChanges()
  {
    std::vector<std::int64_t> change(this->Now.size(), 0);
    std::swap(change, this->Change);
    if (!this->HasSmall)
    {
      return std::vector<std::int64_t>(change.size(), 0);
    }
    this->Group->Sum(change);
    return change;
  }

  /// Labels of fewer cells pay more for each of them.
  static constexpr Index SmallLabel = 1000;
  /// Price of a cell too many, relative to a cell too few.
  static constexpr double PriceOfGrowth = 0.3;

  std::vector<std::int64_t> First, Now, Change;
  Ranks* Group;
  bool HasSmall = false; // if false, sizes do not matter
};

} // namespace vfm
