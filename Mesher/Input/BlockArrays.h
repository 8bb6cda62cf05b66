/**
 * BlockArrays: interface to the arrays of a block of the input (VTK data sets, numpy arrays, ...).
 */
#pragma once

#include "Base/IndexBox.h"
#include "Input/ValueType.h"

#include <memory>
#include <string>
#include <vector>

namespace vfm
{

/// An array with one tuple per cell, x fastest. Read by several threads.
class BlockArray
{
public:
  virtual ~BlockArray() = default;

  int Type = ValueType::Double; ///< one of ValueType
  int Components = 1;
  Index Tuples = 0;
  std::vector<std::string> ComponentNames; ///< empty, or one per component; "" if unnamed
  /// All values, shape (Tuples, Components), row-major; null if they are stored in another way.
  const void* Memory = nullptr;

  /// Returns a value as a double.
  virtual double Get(Index tuple, int component) const = 0;
  /// Copies tuples in the type of messages (CarrierType); only used if Memory is null.
  virtual void Copy(Index first, Index count, void* to) const = 0;
};

/// The arrays of one or several blocks.
class BlockArrays
{
public:
  virtual ~BlockArrays() = default;

  /// Returns the number of cells, or of points if points are used as cells.
  virtual Index NumberOfTuples() const = 0;
  /// Returns the numeric array with a name, or null. Called by one thread.
  virtual std::shared_ptr<const BlockArray> Find(const std::string& name) const = 0;
  /// Returns whether the array with a name holds ids of cells or points.
  virtual bool HoldsIds(const std::string& name) const = 0;
  /// Returns the names of all arrays, for messages.
  virtual std::vector<std::string> Names() const = 0;
};

} // namespace vfm
