/**
 * RangeLabels: labels by ranges of the values of another array, the option Threshold.
 */
#pragma once

#include "Input/BlockArrays.h"
#include "Options/ValueRanges.h"

#include <utility>

namespace vfm
{

/// The number of the range that holds a value, from 1; 0: no range. Computed when it is read.
class RangeLabels : public BlockArray
{
public:
  RangeLabels(std::shared_ptr<const BlockArray> values, std::vector<ValueRange> ranges) :
    Values(std::move(values)), Ranges(std::move(ranges))
  {
    this->Type = ValueType::Int;
    this->Tuples = this->Values->Tuples;
  }

  double Get(Index tuple, int) const override { return this->LabelOf(tuple); }
  void Copy(Index first, Index count, void* to) const override
  {
    for (Index i = 0; i < count; ++i)
    {
      static_cast<int*>(to)[i] = this->LabelOf(first + i);
    }
  }

private:
  int LabelOf(Index tuple) const
  {
    const double value = this->Values->Get(tuple, 0);
    int label = 0;
    for (std::size_t r = 0; label == 0 && r < this->Ranges.size(); ++r)
    {
      label = this->Ranges[r].Holds(value) ? static_cast<int>(r) + 1 : 0;
    }
    return label;
  }

  std::shared_ptr<const BlockArray> Values;
  std::vector<ValueRange> Ranges;
};

} // namespace vfm
