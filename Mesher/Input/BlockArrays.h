/**
 * BlockArrays: the arrays of a block of the input, whoever holds them: a data set of VTK, or arrays of numpy.
 */
#pragma once

#include "Base/IndexBox.h"
#include "Input/ValueType.h"

#include <memory>
#include <string>
#include <vector>

namespace vfm
{

/// An array with a tuple a cell, in the order of the block.
class BlockArray
{
public:
  virtual ~BlockArray() = default;

  int Type = ValueType::Double; ///< of ValueType
  int Components = 1;
  Index Tuples = 0;
  std::vector<std::string> ComponentNames; ///< empty, or one a component, "" where it has none
  const void* Memory = nullptr;            ///< all values, tuple by tuple; null: they lie otherwise

  /// Without Memory: a value as a double, and tuples copied in the type in which they travel (CarrierType).
  virtual double Get(Index tuple, int component) const = 0;
  virtual void Copy(Index first, Index count, void* to) const = 0;
};

class BlockArrays
{
public:
  virtual ~BlockArrays() = default;

  /// Cells, or points where these are cells.
  virtual Index NumberOfTuples() const = 0;
  /// Null when none of numbers has that name. Called by one thread.
  virtual std::shared_ptr<const BlockArray> Find(const std::string& name) const = 0;
  /// Whether the array of that name numbers cells or points.
  virtual bool HoldsIds(const std::string& name) const = 0;
  /// For messages.
  virtual std::vector<std::string> Names() const = 0;
};

} // namespace vfm
