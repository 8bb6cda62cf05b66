#include "Input/InputLabels.h"

#include "Base/ParseText.h"
#include "Base/Runtime.h"
#include "Input/ArrayInfo.h"
#include "Input/InputArrays.h"
#include "Input/RangeLabels.h"
#include "Ranks/Agreement.h"

#include <cmath>
#include <limits>
#include <unordered_set>

namespace vfm
{
namespace
{

constexpr Index RowLength = 4096; // labels read at a time

constexpr int LargestLabel = std::numeric_limits<int>::max();

/// Returns a value as text that shows why it is not a label: 1.25, 0.998.
std::string Print(Index value)
{
  return std::to_string(value);
}
/// Values of single precision have up to 9 digits.
std::string Print(double value)
{
  if (!std::isfinite(value))
  {
    return std::isnan(value) ? "nan" : value < 0.0 ? "-inf" : "inf";
  }
  const bool isSingle = std::abs(value) <= std::numeric_limits<float>::max() &&
    static_cast<double>(static_cast<float>(value)) == value;
  return isSingle ? FormatNumber(static_cast<float>(value)) : FormatNumber(value);
}

/// Returns a value as a label. Value: Index, or double for arrays of reals.
template <class Value>
int CheckedLabel(Value value, const std::string& name, const Index3& first, Index offset)
{
  const Value nearest = static_cast<Value>(std::round(static_cast<double>(value)));
  const bool isLabel = nearest >= 0 && nearest <= LargestLabel; // nor NaN
  if (!isLabel || std::abs(static_cast<double>(value - nearest)) > LabelTolerance)
  {
    const std::string way = value < 0
      ? " Replace negative ids by unused ones first: in ParaView by the filter Calculator on cell "
        "data, for instance if(" +
        name + " < 0, 1000000 - " + name + ", " + name + "), in Python by numpy.where."
      : "";
    throw InputError("The material id array '" + name + "' holds " + Print(value) + " in " +
      TextOf({ { first[0] + offset, first[1], first[2] } }) +
      ": material ids are integers in [0, " + std::to_string(LargestLabel) +
      "], 0 is void. If the values are a level set, grey values or another quantity, Threshold "
      "(--threshold LOW:HIGH) makes materials of ranges of them." +
      way);
  }
  return static_cast<int>(nearest);
}

/// Calls visit(first cell, count) for the rows of a box; long rows are split.
template <class Visit>
void VisitRows(const IndexBox& box, const Visit& visit)
{
  ForRows(box,
    [&](Index j, Index k)
    {
      for (Index i = box.Lower[0]; i < box.Upper[0]; i += RowLength)
      {
        visit(Index3{ { i, j, k } }, std::min(RowLength, box.Upper[0] - i));
      }
    });
}

class LabelCells : public InputCells
{
public:
  LabelCells(const InputBlocks& input, const LabelSource& source) :
    InputCells(input), Name(source.Array)
  {
    for (const InputBlock& block : input.Blocks)
    {
      const auto array = FindMaterialArray(block, source.Array);
      this->Columns.emplace_back(
        source.Ranges.empty() ? array : std::make_shared<RangeLabels>(array, source.Ranges));
    }
  }

  /// Returns the labels on this rank, and 0. Throws InputError if a value is not a label.
  std::vector<int> FindLabels() const;
  /// Returns whether a cell that is not blanked has label 0.
  bool HasZero() const;
  /// Sets the labels of all ranks, increasing, 0 first.
  /// @param isZeroMaterial whether label 0 is a material, which gets the next id
  /// @throws InputError if there is no next id
  void SetTable(std::vector<int> labels, bool isZeroMaterial);

  SparseCells Extract(std::size_t block, const IndexBox& box) const override;
  InputField MakeField(
    const CartesianGrid& grid, const std::vector<SparseCells>& received) const override;

protected:
  void ReadMaterials(
    std::size_t block, const Index3& first, Index count, int* materials) const override;

private:
  template <class Value>
  void FindLabels(std::size_t block, std::unordered_set<int>& found) const;
  int MaterialOf(Index label) const;
  /// Calls visit(offset in the row, length, material) for runs of one material in a row of a block.
  template <class Visit>
  void VisitMaterials(
    std::size_t block, const Index3& first, Index count, const Visit& visit) const;

  std::string Name;
  std::vector<Column<Index>> Columns; // labels of each block
  Materials Table;
  int ZeroMaterial = 0; // number of the material with label 0; 0: void
};

template <class Value>
void LabelCells::FindLabels(std::size_t block, std::unordered_set<int>& found) const
{
  const InputBlock& own = this->Input.Blocks[block];
  const Column<Value> column(this->Columns[block].Array);
  Value last = 0;
  VisitRows(own.Box,
    [&](const Index3& first, Index count)
    {
      ReadRuns(own, column, first, count,
        [&](Index offset, Index, Value value)
        {
          if (value != last) // NaN too
          {
            last = value;
            found.insert(CheckedLabel(last, this->Name, first, offset));
          }
        });
    });
}

std::vector<int> LabelCells::FindLabels() const
{
  std::unordered_set<int> found{ 0 };
  for (std::size_t b = 0; b < this->Columns.size(); ++b)
  {
    if (IsRealType(this->Columns[b].Array->Type))
    {
      this->FindLabels<double>(b, found);
    }
    else
    {
      this->FindLabels<Index>(b, found);
    }
  }
  return { found.begin(), found.end() };
}

bool LabelCells::HasZero() const
{
  bool isFound = false;
  for (std::size_t b = 0; b < this->Columns.size(); ++b)
  {
    const InputBlock& block = this->Input.Blocks[b];
    VisitRows(block.Box,
      [&](const Index3& first, Index count)
      {
        ReadRuns(block, this->Columns[b], first, count,
          [&](Index offset, Index, Index label)
          { isFound = isFound || (label == 0 && !IsHidden(block, block.CellId(first) + offset)); });
      });
  }
  return isFound;
}

void LabelCells::SetTable(std::vector<int> labels, bool isZeroMaterial)
{
  this->Table = { { "Void" }, std::move(labels), 0 };
  if (isZeroMaterial)
  {
    if (this->Table.Labels.back() == LargestLabel)
    {
      throw InputError("The material id array '" + this->Name + "' holds the largest id, " +
        std::to_string(LargestLabel) + ", so that ZeroLabel Material has no id for label 0.");
    }
    this->Table.ZeroId = this->Table.Labels.back() + 1;
    this->ZeroMaterial = static_cast<int>(this->Table.Labels.size());
    this->Table.Labels.push_back(this->Table.ZeroId);
  }
  for (std::size_t m = 1; m < this->Table.Labels.size(); ++m)
  {
    const int label = this->Table.Labels[m] == this->Table.ZeroId ? 0 : this->Table.Labels[m];
    this->Table.Names.push_back("Material " + std::to_string(label));
  }
}

int LabelCells::MaterialOf(Index label) const
{
  const std::vector<int>& labels = this->Table.Labels;
  return static_cast<int>(
    std::lower_bound(labels.begin(), labels.end(), static_cast<int>(label)) - labels.begin());
}

template <class Visit>
void LabelCells::VisitMaterials(
  std::size_t block, const Index3& first, Index count, const Visit& visit) const
{
  const InputBlock& own = this->Input.Blocks[block];
  ReadRuns(own, this->Columns[block], first, count,
    [&](Index offset, Index length, Index label)
    {
      // Runs of blocks with blanked cells have one cell.
      const bool isZero =
        label == 0 && this->ZeroMaterial > 0 && !IsHidden(own, own.CellId(first) + offset);
      visit(offset, length, isZero ? this->ZeroMaterial : this->MaterialOf(label));
    });
}

void LabelCells::ReadMaterials(
  std::size_t block, const Index3& first, Index count, int* materials) const
{
  this->VisitMaterials(block, first, count,
    [&](Index offset, Index length, int material)
    { std::fill_n(materials + offset, length, material); });
}

SparseCells LabelCells::Extract(std::size_t block, const IndexBox& box) const
{
  SparseCells cells;
  cells.Box = box;
  cells.Entry.resize(box.NumberOfCells());
  VisitRows(box,
    [&](const Index3& first, Index count)
    { this->ReadMaterials(block, first, count, cells.Entry.data() + cells.CellId(first)); });
  return cells;
}

InputField LabelCells::MakeField(
  const CartesianGrid& grid, const std::vector<SparseCells>& received) const
{
  InputField field{ FractionField(grid, static_cast<int>(this->Table.Labels.size()) - 1),
    this->Table, {} };
  FractionField::RowWriter writer(field.Fractions);
  for (std::size_t b = 0; b < this->Columns.size(); ++b)
  {
    VisitRows(Intersect(this->Input.Blocks[b].Box, grid.Local()),
      [&](const Index3& first, Index count)
      {
        writer.Start(grid.Linear(first));
        this->VisitMaterials(b, first, count,
          [&](Index, Index length, int material) { writer.AddLabel(material, length); });
        writer.Finish();
      });
  }
  for (const SparseCells& cells : received)
  {
    VisitRows(Intersect(cells.Box, grid.Local()),
      [&](const Index3& first, Index count)
      {
        writer.Start(grid.Linear(first));
        const int* materials = cells.Entry.data() + cells.CellId(first);
        std::for_each(
          materials, materials + count, [&](int material) { writer.AddLabel(material); });
        writer.Finish();
      });
  }
  return field;
}

} // namespace

LevelCells OpenLabels(
  const std::vector<InputBlocks>& levels, const LabelSource& source, Ranks& ranks)
{
  bool hasZero = false;
  LevelCells cells;
  std::vector<LabelCells*> opened;
  std::vector<int> labels;
  WorkTogether(ranks,
    [&]
    {
      for (const InputBlocks& level : levels)
      {
        auto own = std::make_unique<LabelCells>(level, source);
        const std::vector<int> found = own->FindLabels();
        labels.insert(labels.end(), found.begin(), found.end());
        hasZero = hasZero || (source.IsZeroMaterial && own->HasZero());
        opened.push_back(own.get());
        cells.push_back(std::move(own));
      }
    });
  labels = UnionOverRanks(ranks, std::move(labels));
  hasZero = ranks.Any(hasZero);
  for (LabelCells* own : opened)
  {
    own->SetTable(labels, hasZero);
  }
  return cells;
}

} // namespace vfm
