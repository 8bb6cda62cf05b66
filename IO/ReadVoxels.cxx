#include "ReadVoxels.h"

#include "OpenFile.h"
#include "ReadLabelText.h"
#include "SwapBytes.h"
#include "VoxelRows.h"

#include <algorithm>
#include <limits>
#include <type_traits>

namespace vfm
{
namespace
{

/// Returns whether a type can hold values that are not labels.
template <class Stored>
constexpr bool CanBeWrong()
{
  return std::is_integral<Stored>::value &&
    (std::is_signed<Stored>::value || sizeof(Stored) >= sizeof(int));
}

/// Returns whether a value is no label, or no int if any numbers are accepted.
template <class Stored>
bool IsWrong(Stored value, bool areAnyNumbers)
{
  if constexpr (CanBeWrong<Stored>())
  {
    constexpr auto most = static_cast<std::uint64_t>(std::numeric_limits<int>::max());
    return value < Stored(0)
      ? !areAnyNumbers || static_cast<std::int64_t>(value) < std::numeric_limits<int>::min()
      : static_cast<std::uint64_t>(value) > most;
  }
  return false;
}

template <class Stored>
[[noreturn]] void RejectLabel(const Index3& cell, Stored value)
{
  throw InputError("the label of cell (" + std::to_string(cell[0]) + ", " +
    std::to_string(cell[1]) + ", " + std::to_string(cell[2]) + ") is " + std::to_string(value) +
    ". Labels are integers from 0 to 2147483647.");
}

/// Reads an array of a NumPy file, which begins at the position of the stream.
template <class Stored, class Kept>
void ReadArray(
  std::istream& stream, bool swap, bool areAnyNumbers, const VoxelRows& rows, void* cells)
{
  Kept* kept = static_cast<Kept*>(cells);
  std::vector<Stored> values(rows.Length());
  const std::streamsize size = values.size() * sizeof(Stored);
  for (Index plane = 0; plane < rows.Planes(); ++plane)
  {
    if (!CanBeWrong<Stored>() && !rows.HasPlane(plane))
    {
      stream.seekg(size * rows.RowsInPlane(), std::ios::cur);
      continue;
    }
    for (Index row = 0; row < rows.RowsInPlane(); ++row)
    {
      stream.read(reinterpret_cast<char*>(values.data()), size);
      if (!stream)
      {
        throw InputError("its values cannot be read to the end.");
      }
      if (swap)
      {
        std::transform(values.begin(), values.end(), values.begin(), SwapBytes<Stored>);
      }
      const auto wrong = std::find_if(values.begin(), values.end(),
        [areAnyNumbers](Stored value) { return IsWrong(value, areAnyNumbers); });
      if (wrong != values.end())
      {
        RejectLabel(rows.Cell(plane, row, wrong - values.begin()), *wrong);
      }
      const VoxelRows::Part part = rows.Find(plane, row);
      Kept* to = kept + part.Cell;
      for (Index i = part.First; i < part.Last; ++i, to += part.Stride)
      {
        *to = static_cast<Kept>(values[i]);
      }
    }
  }
}

/// Type of values in a NumPy file, their type in memory, and the function that reads them.
struct StoredType
{
  char Kind;
  int Size;
  int Type; ///< type in memory, one of ValueType
  void (*Read)(
    std::istream& stream, bool swap, bool areAnyNumbers, const VoxelRows& rows, void* cells);
};

constexpr StoredType StoredTypes[] = {
  { 'b', 1, ValueType::UnsignedChar, ReadArray<std::uint8_t, unsigned char> },
  { 'u', 1, ValueType::UnsignedChar, ReadArray<std::uint8_t, unsigned char> },
  { 'i', 1, ValueType::SignedChar, ReadArray<std::int8_t, signed char> },
  { 'u', 2, ValueType::UnsignedShort, ReadArray<std::uint16_t, unsigned short> },
  { 'i', 2, ValueType::Short, ReadArray<std::int16_t, short> },
  { 'u', 4, ValueType::Int, ReadArray<std::uint32_t, int> },
  { 'i', 4, ValueType::Int, ReadArray<std::int32_t, int> },
  { 'u', 8, ValueType::Int, ReadArray<std::uint64_t, int> },
  { 'i', 8, ValueType::Int, ReadArray<std::int64_t, int> },
  { 'f', 4, ValueType::Float, ReadArray<float, float> },
  { 'f', 8, ValueType::Double, ReadArray<double, double> },
};

std::vector<TypedValues> ReadNumPy(const VoxelFile& file, const IndexBox& box)
{
  const NumPyHeader& header = *file.NumPy;
  const StoredType& type = *std::find_if(std::begin(StoredTypes), std::end(StoredTypes),
    [&header](const StoredType& t) { return t.Kind == header.Kind && t.Size == header.Size; });
  std::ifstream stream = OpenFile(file.Path);
  const VoxelRows rows(file, box);
  const Index arrays = header.Shape.size() == 4 ? header.Shape[0] : 0;
  const std::string name = file.IsFractions() ? "VolumeFraction" : "MaterialId";
  std::vector<TypedValues> result;
  const Index size = file.Cells[0] * file.Cells[1] * file.Cells[2] * header.Size;
  for (Index i = 0; i < std::max<Index>(arrays, 1); ++i)
  {
    stream.seekg(header.Offset + i * size);
    result.push_back(
      MakeValues(name + (arrays ? std::to_string(i + 1) : ""), type.Type, box.NumberOfCells()));
    type.Read(stream, header.SwapBytes, file.AreAnyNumbers, rows, result.back().Bytes.data());
  }
  return result;
}

} // namespace

std::vector<TypedValues> ReadVoxels(const VoxelFile& file, const IndexBox& box)
{
  if (file.NumPy)
  {
    return ReadNumPy(file, box);
  }
  CheckLabelCount(file); // before memory is allocated
  std::vector<TypedValues> labels;
  labels.push_back(MakeValues("MaterialId", ValueType::Int, box.NumberOfCells()));
  ReadLabelText(file, box, reinterpret_cast<int*>(labels[0].Bytes.data()));
  return labels;
}

} // namespace vfm
