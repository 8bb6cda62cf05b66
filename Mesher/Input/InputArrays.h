/**
 * InputArrays: reads cell arrays of blocks row by row, without copying them. If points are used as
 * cells, the arrays are point data.
 */
#pragma once

#include "Input/InputBlocks.h"

#include <cmath>
#include <memory>
#include <string>
#include <type_traits>

namespace vfm
{

/// Returns the array with a name: one tuple per cell, in the order of the block.
/// @throws InputError if there is no numeric array of that name, or its size is wrong
std::shared_ptr<const BlockArray> FindTuples(const InputBlock& block, const std::string& name);

/// Returns the array with a name and one component.
/// @throws InputError if FindTuples does, or if the array has several components
std::shared_ptr<const BlockArray> FindArray(const InputBlock& block, const std::string& name);

/// Returns an array that may hold materials.
/// @throws InputError if FindArray does, or if the array holds ids of cells or points
std::shared_ptr<const BlockArray> FindMaterialArray(
  const InputBlock& block, const std::string& name);

/// Reads count consecutive values of an array, beginning at first.
template <class Value>
using RowReader = void (*)(const void* values, Index first, Index count, Value* row);

/// Returns the stored value that means 1: 255 for fractions of type unsigned char, 1 for labels.
template <class Value>
constexpr Value StoredOne(bool bytes)
{
  return std::is_same<Value, double>::value && bytes ? Value(255) : Value(1);
}

/// Converts a stored value. Reals become the nearest integer; 0 outside the range of integers
/// (blanked cells).
template <class Value, class Stored>
Value Convert(Stored stored)
{
  constexpr double largest = 0x1p62;
  if constexpr (std::is_integral<Value>::value && std::is_floating_point<Stored>::value)
  {
    return std::fabs(stored) < largest ? static_cast<Value>(stored + std::copysign(0.5, stored))
                                       : Value(0);
  }
  return static_cast<Value>(stored);
}

template <class Value, class Stored>
void ReadMemory(const void* values, Index first, Index count, Value* row)
{
  constexpr Value one = StoredOne<Value>(std::is_same<Stored, unsigned char>::value);
  const Stored* stored = static_cast<const Stored*>(values) + first;
  for (Index i = 0; i < count; ++i)
  {
    row[i] = Convert<Value>(stored[i]) / one;
  }
}

/// Reads the value at first; returns how many values from there on, up to count, are equal.
template <class Value>
using EqualRunReader = Index (*)(const void* values, Index first, Index count, Value& value);

template <class Value, class Stored>
Index ReadMemoryRun(const void* values, Index first, Index count, Value& value)
{
  constexpr Index block = 16; // values that are compared together
  const Stored* stored = static_cast<const Stored*>(values) + first;
  const Stored same = *stored;
  ReadMemory<Value, Stored>(values, first, 1, &value);
  Index n = 1;
  for (bool areEqual = true; areEqual && n + block <= count; n += areEqual ? block : 0)
  {
    int others = 0;
    for (Index i = 0; i < block; ++i)
    {
      others += stored[n + i] != same;
    }
    areEqual = others == 0;
  }
  while (n < count && stored[n] == same)
  {
    ++n;
  }
  return n;
}

/// Reads arrays that are not plain memory; values points to the BlockArray.
template <class Value>
void ReadArray(const void* values, Index first, Index count, Value* row)
{
  const BlockArray* array = static_cast<const BlockArray*>(values);
  const Value one = StoredOne<Value>(array->Type == ValueType::UnsignedChar);
  for (Index i = 0; i < count; ++i)
  {
    row[i] = Convert<Value>(array->Get(first + i, 0)) / one;
  }
}

template <class Value>
Index ReadArrayRun(const void* values, Index first, Index, Value& value)
{
  ReadArray<Value>(values, first, 1, &value);
  return 1;
}

/// An array of one block, with readers for its type.
template <class Value>
struct Column
{
  std::shared_ptr<const BlockArray> Array;
  const void* Values;
  RowReader<Value> Read = ReadArray<Value>;
  EqualRunReader<Value> ReadRun = ReadArrayRun<Value>;

  explicit Column(std::shared_ptr<const BlockArray> array) :
    Array(std::move(array)), Values(this->Array.get())
  {
    if (this->Array->Memory)
    {
      this->Values = this->Array->Memory;
      VisitType(this->Array->Type,
        [this](auto tag)
        {
          using Stored = typename decltype(tag)::Type;
          this->Read = ReadMemory<Value, Stored>;
          this->ReadRun = ReadMemoryRun<Value, Stored>;
        });
    }
  }
};

/// Returns whether a cell is blanked; id: position in the arrays.
inline bool IsHidden(const InputBlock& block, Index id)
{
  return block.Marks && ((*block.Marks)[id] & CellMark::Hidden) != 0;
}

/// Sets the values of blanked cells in a row of one block to 0.
template <class Value>
void ClearHidden(const InputBlock& block, Index first, Index count, Value* row)
{
  if (block.Marks)
  {
    const unsigned char* marks = block.Marks->data() + first;
    for (Index i = 0; i < count; ++i)
    {
      row[i] = (marks[i] & CellMark::Hidden) ? Value(0) : row[i];
    }
  }
}

/// Reads a row of cells along x of one block; values of blanked cells are 0.
/// @param first first cell, in indices of the global grid
template <class Value>
void ReadRow(const InputBlock& block, const Column<Value>& column, const Index3& first, Index count,
  Value* row)
{
  const Index id = block.CellId(first);
  column.Read(column.Values, id, count, row);
  ClearHidden(block, id, count, row);
}

/// Calls visit(offset in the row, length, value) for runs of equal values of a row, in order.
template <class Value, class Visit>
void ReadRuns(const InputBlock& block, const Column<Value>& column, const Index3& first,
  Index count, const Visit& visit)
{
  const Index id = block.CellId(first);
  for (Index at = 0, length; at < count; at += length)
  {
    Value value;
    const Index most = block.Marks ? 1 : count - at; // each may be blanked
    length = column.ReadRun(column.Values, id + at, most, value);
    ClearHidden(block, id + at, 1, &value);
    visit(at, length, value);
  }
}

} // namespace vfm
