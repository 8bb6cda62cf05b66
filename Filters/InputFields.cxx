#include "InputFields.h"

#include "Runtime.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <limits>
#include <sstream>
#include <type_traits>
#include <unordered_set>

namespace vfm
{
namespace
{

constexpr Index RowLength = 4096;              // labels read at a time
constexpr double ByteRounding = 0.50001 / 255; // of a fraction stored as unsigned char

/// Reads count consecutive values of an array, from the value first on.
template <class Value>
using RowReader = void (*)(const void* values, Index first, Index count, Value* row);

/// The stored value that stands for 1: fractions of type unsigned char count 0..255, labels never.
template <class Value>
constexpr Value StoredOne(bool bytes)
{
  return std::is_same<Value, double>::value && bytes ? Value(255) : Value(1);
}

template <class Value, class Stored>
void ReadMemory(const void* values, Index first, Index count, Value* row)
{
  constexpr Value one = StoredOne<Value>(std::is_same<Stored, unsigned char>::value);
  const Stored* stored = static_cast<const Stored*>(values) + first;
  for (Index i = 0; i < count; ++i)
  {
    row[i] = static_cast<Value>(stored[i]) / one;
  }
}

/// For arrays that are not plain memory; values is the vtkDataArray.
template <class Value>
void ReadArray(const void* values, Index first, Index count, Value* row)
{
  vtkDataArray* array = static_cast<vtkDataArray*>(const_cast<void*>(values));
  const Value one = StoredOne<Value>(array->GetDataType() == VTK_UNSIGNED_CHAR);
  for (Index i = 0; i < count; ++i)
  {
    row[i] = static_cast<Value>(array->GetComponent(first + i, 0)) / one;
  }
}

/// A cell array of one block.
template <class Value>
struct Column
{
  const void* Values;
  RowReader<Value> Read = ReadArray<Value>;

  explicit Column(vtkDataArray* array) : Values(array)
  {
    if (array->HasStandardMemoryLayout())
    {
      switch (array->GetDataType())
      {
        vtkTemplateMacro(this->SetMemory<VTK_TT>(array));
      }
    }
  }

private:
  template <class Stored>
  void SetMemory(vtkDataArray* array)
  {
    this->Values = array->GetVoidPointer(0);
    this->Read = ReadMemory<Value, Stored>;
  }
};

std::string ArrayNames(vtkDataSetAttributes* attributes)
{
  std::string names;
  for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
  {
    const char* name = attributes->GetArrayName(i);
    names += (names.empty() ? "'" : ", '") + std::string(name ? name : "") + "'";
  }
  return names.empty() ? "none" : names;
}

/// The cell array of that name with one component and a value a cell.
vtkDataArray* FindArray(const InputBlock& block, const std::string& name)
{
  vtkDataArray* array = block.Data->GetCellData()->GetArray(name.c_str());
  if (!array && block.Data->GetPointData()->HasArray(name.c_str()))
  {
    throw InputError("'" + name +
      "' is point data. Volume fractions and material ids are cell "
      "data: apply the filter Point Data to Cell Data first.");
  }
  if (!array)
  {
    throw InputError(block.Name + " has no numeric cell array '" + name +
      "'. Its cell arrays: " + ArrayNames(block.Data->GetCellData()) + ".");
  }
  if (array->GetNumberOfComponents() != 1)
  {
    throw InputError("The cell array '" + name + "' has " +
      std::to_string(array->GetNumberOfComponents()) +
      " components: an array with one value a cell is needed.");
  }
  if (array->GetNumberOfTuples() != block.Data->GetNumberOfCells())
  {
    throw InputError(block.Name + ": the cell array '" + name + "' has " +
      std::to_string(array->GetNumberOfTuples()) + " values for " +
      std::to_string(block.Data->GetNumberOfCells()) + " cells.");
  }
  return array;
}

/// Sets the values of blanked cells in a row of one block to 0.
template <class Value>
void ClearHidden(const InputBlock& block, Index first, Index count, Value* row)
{
  if (block.GhostTypes)
  {
    const unsigned char* types = block.GhostTypes->GetPointer(first);
    for (Index i = 0; i < count; ++i)
    {
      row[i] = (types[i] & vtkDataSetAttributes::HIDDENCELL) ? Value(0) : row[i];
    }
  }
}

class BlockReader : public FractionField::Reader
{
public:
  BlockReader(const InputBlocks& input, const std::vector<std::string>& names) :
    Input(input), Names(names)
  {
    for (const InputBlock& block : input.Blocks)
    {
      int bytes = 0;
      for (const std::string& name : names)
      {
        vtkDataArray* array = FindArray(block, name);
        bytes += array->GetDataType() == VTK_UNSIGNED_CHAR;
        this->Columns.emplace_back(array);
      }
      this->Bytes = std::max(this->Bytes, bytes);
    }
  }

  void Read(int material, const Index3& first, Index count, double* values) const override
  {
    for (int b : this->Input.Layers[first[2]])
    {
      const InputBlock& block = this->Input.Blocks[b];
      const Index begin = std::max(first[0], block.Box.Lower[0]);
      const Index end = std::min(first[0] + count, block.Box.Upper[0]);
      if (first[1] < block.Box.Lower[1] || first[1] >= block.Box.Upper[1] || begin >= end)
      {
        continue;
      }
      const Index id = block.CellId({ { begin, first[1], first[2] } });
      double* row = values + (begin - first[0]);
      const Column<double>& column = this->Columns[b * this->Names.size() + material - 1];
      column.Read(column.Values, id, end - begin, row);
      ClearHidden(block, id, end - begin, row);
    }
  }

  /// Fractions of type unsigned char are rounded: 128 + 128 is 256 / 255.
  double SumTolerance() const override
  {
    return std::max(FractionField::Reader::SumTolerance(), ByteRounding * this->Bytes);
  }

  std::string Name(int material) const override { return this->Names[material - 1]; }

private:
  const InputBlocks& Input;
  const std::vector<std::string>& Names;
  int Bytes = 0;                       // arrays of type unsigned char, in the block that has most
  std::vector<Column<double>> Columns; // of each block, its materials
};

/// Calls visit(first cell, count, labels) for the rows of all blocks.
template <class Visit>
void VisitLabels(const InputBlocks& input, const std::string& name, Visit&& visit)
{
  std::vector<Index> row(RowLength);
  for (const InputBlock& block : input.Blocks)
  {
    const Column<Index> column(FindArray(block, name));
    for (Index k = block.Box.Lower[2]; k < block.Box.Upper[2]; ++k)
    {
      for (Index j = block.Box.Lower[1]; j < block.Box.Upper[1]; ++j)
      {
        for (Index i = block.Box.Lower[0]; i < block.Box.Upper[0]; i += RowLength)
        {
          const Index3 first{ { i, j, k } };
          const Index count = std::min(RowLength, block.Box.Upper[0] - i);
          const Index id = block.CellId(first);
          column.Read(column.Values, id, count, row.data());
          ClearHidden(block, id, count, row.data());
          visit(first, count, row.data());
        }
      }
    }
  }
}

void CheckLabelTypes(const InputBlocks& input, const std::string& name)
{
  for (const InputBlock& block : input.Blocks)
  {
    vtkDataArray* array = FindArray(block, name);
    if (array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE)
    {
      throw InputError("The material id array '" + name + "' is of type " +
        array->GetDataTypeAsString() +
        ": material ids are integers. Convert it (filter Calculator, result array type Int), or "
        "choose it as a volume fraction array.");
    }
  }
}

/// The labels that occur, 0 first, in increasing order.
std::vector<int> FindLabels(const InputBlocks& input, const std::string& name)
{
  std::unordered_set<Index> found{ 0 };
  Index last = 0;
  VisitLabels(input, name,
    [&](const Index3& first, Index count, const Index* labels)
    {
      for (Index c = 0; c < count; ++c)
      {
        if (labels[c] == last)
        {
          continue;
        }
        last = labels[c];
        if (last < 0 || last > std::numeric_limits<int>::max())
        {
          std::ostringstream text;
          text << "The material id array '" << name << "' holds " << last << " in cell ("
               << first[0] + c << ", " << first[1] << ", " << first[2]
               << "): material ids lie in [0, " << std::numeric_limits<int>::max()
               << "], 0 is void.";
          throw InputError(text.str());
        }
        found.insert(last);
      }
    });
  std::vector<int> sorted(found.begin(), found.end());
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

} // namespace

InputField ReadFractions(
  const CartesianGrid& grid, const InputBlocks& input, const std::vector<std::string>& names)
{
  const int count = static_cast<int>(names.size());
  Materials table{ { "Void" }, { 0 } };
  for (int m = 1; m <= count; ++m)
  {
    table.Names.push_back(names[m - 1]);
    table.Labels.push_back(m);
  }
  return { FractionField::FromReader(grid, count, BlockReader(input, names)), std::move(table) };
}

InputField ReadLabels(const CartesianGrid& grid, const InputBlocks& input, const std::string& name)
{
  CheckLabelTypes(input, name);
  Materials table{ { "Void" }, FindLabels(input, name) };
  for (std::size_t m = 1; m < table.Labels.size(); ++m)
  {
    table.Names.push_back("Material " + std::to_string(table.Labels[m]));
  }
  InputField field{ FractionField(grid, static_cast<int>(table.Labels.size()) - 1),
    std::move(table) };
  const std::vector<int>& labels = field.Table.Labels;
  Index last = 0;
  int material = 0;
  VisitLabels(input, name,
    [&](const Index3& first, Index count, const Index* row)
    {
      const Index base = grid.Linear(first);
      for (Index c = 0; c < count; ++c)
      {
        if (row[c] != last)
        {
          last = row[c];
          material = static_cast<int>(
            std::lower_bound(labels.begin(), labels.end(), static_cast<int>(last)) -
            labels.begin());
        }
        field.Fractions.SetLabel(base + c, material);
      }
    });
  return field;
}

} // namespace vfm
