/**
 * The arrays of the cells of the input's blocks, read in rows without copying them. Where points are cells they are point data.
 */
#pragma once

#include "Input/InputBlocks.h"

#include <cmath>
#include <memory>
#include <string>
#include <type_traits>

namespace vfm
{

/// The array of that name with a tuple a cell, in the order of the block. Throws InputError when there is none of numbers.
std::shared_ptr<const BlockArray> FindTuples(const InputBlock& block, const std::string& name);

/// The array of that name with one component and a value a cell. Throws InputError when there is none.
std::shared_ptr<const BlockArray> FindArray(const InputBlock& block, const std::string& name);

/// The same of an array that holds materials: of ids, which number cells or points, throws InputError.
std::shared_ptr<const BlockArray> FindMaterialArray(
  const InputBlock& block, const std::string& name);

/// Reads count consecutive values of an array, from the value first on.
template <class Value>
using RowReader = void (*)(const void* values, Index first, Index count, Value* row);

/// The stored value that stands for 1: fractions of type unsigned char count 0..255, labels never.
template <class Value>
constexpr Value StoredOne(bool bytes)
{
  return std::is_same<Value, double>::value && bytes ? Value(255) : Value(1);
}

/// Real numbers that are no labels, as those of blanked cells may be, become 0.
template <class Value, class Stored>
Value Convert(Stored stored)
{
  constexpr double largest = 0x1p62;
  if constexpr (std::is_integral<Value>::value && std::is_floating_point<Stored>::value)
  {
    return std::fabs(stored) < largest ? static_cast<Value>(stored) : Value(0);
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

/// Reads the value first; returns how many from there on, of count, are known to be the same.
template <class Value>
using EqualRunReader = Index (*)(const void* values, Index first, Index count, Value& value);

template <class Value, class Stored>
Index ReadMemoryRun(const void* values, Index first, Index count, Value& value)
{
  constexpr Index block = 16; // are compared at once
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

/// For arrays that are not plain memory; values is the BlockArray.
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

/// An array of one block.
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

/// Whether a cell, by its place in the arrays, is blanked.
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

/// Reads the values of a row of cells along x of one block, given in the indices of the global grid; those of
/// blanked cells are 0.
template <class Value>
void ReadRow(const InputBlock& block, const Column<Value>& column, const Index3& first, Index count,
  Value* row)
{
  const Index id = block.CellId(first);
  column.Read(column.Values, id, count, row);
  ClearHidden(block, id, count, row);
}

/// Calls visit(offset in the row, length, value) for the cells of such a row in order, alike ones together.
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
