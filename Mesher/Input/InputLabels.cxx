#include "Input/InputLabels.h"

#include "Base/Runtime.h"
#include "Input/InputArrays.h"
#include "Ranks/Agreement.h"

#include <limits>
#include <sstream>
#include <unordered_set>

namespace vfm
{
namespace
{

constexpr Index RowLength = 4096; // labels read at a time

/// Returns a value as a label. Value: Index, or double for arrays of reals.
template <class Value>
int CheckedLabel(Value value, const std::string& name, const Index3& first, Index offset)
{
  const bool isLabel = value >= 0 && value <= std::numeric_limits<int>::max(); // nor NaN
  if (!isLabel || static_cast<Value>(static_cast<int>(value)) != value)
  {
    std::ostringstream text;
    text << "The material id array '" << name << "' holds " << value << " in "
         << TextOf({ { first[0] + offset, first[1], first[2] } })
         << ": material ids are integers in [0, " << std::numeric_limits<int>::max()
         << "], 0 is void.";
    if (value < 0)
    {
      text << " Replace negative ids by unused ones first: in ParaView by the filter Calculator on "
              "cell data, for instance if("
           << name << " < 0, 1000000 - " << name << ", " << name << "), in Python by numpy.where.";
    }
    throw InputError(text.str());
  }
  return static_cast<int>(value);
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
  LabelCells(const InputBlocks& input, const std::string& name) : InputCells(input), Name(name)
  {
    for (const InputBlock& block : input.Blocks)
    {
      this->Columns.emplace_back(FindMaterialArray(block, name));
    }
  }

  /// Returns the labels on this rank, and 0. Throws InputError if a value is not a label.
  std::vector<int> FindLabels() const;
  /// Sets the labels of all ranks, increasing, 0 first.
  void SetTable(std::vector<int> labels);

  SparseCells Extract(const InputBlock& block, const IndexBox& box) const override;
  InputField MakeField(
    const CartesianGrid& grid, const std::vector<SparseCells>& received) const override;

protected:
  void ReadMaterials(
    std::size_t block, const Index3& first, Index count, int* materials) const override;

private:
  template <class Value>
  void FindLabels(std::size_t block, std::unordered_set<int>& found) const;
  int MaterialOf(Index label) const;

  std::string Name;
  std::vector<Column<Index>> Columns; // labels of each block
  Materials Table;
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

void LabelCells::SetTable(std::vector<int> labels)
{
  this->Table = { { "Void" }, std::move(labels) };
  for (std::size_t m = 1; m < this->Table.Labels.size(); ++m)
  {
    this->Table.Names.push_back("Material " + std::to_string(this->Table.Labels[m]));
  }
}

int LabelCells::MaterialOf(Index label) const
{
  const std::vector<int>& labels = this->Table.Labels;
  return static_cast<int>(
    std::lower_bound(labels.begin(), labels.end(), static_cast<int>(label)) - labels.begin());
}

void LabelCells::ReadMaterials(
  std::size_t block, const Index3& first, Index count, int* materials) const
{
  ReadRuns(this->Input.Blocks[block], this->Columns[block], first, count,
    [&](Index offset, Index length, Index label)
    { std::fill_n(materials + offset, length, this->MaterialOf(label)); });
}

SparseCells LabelCells::Extract(const InputBlock& block, const IndexBox& box) const
{
  SparseCells cells;
  cells.Box = box;
  cells.Entry.resize(box.NumberOfCells());
  VisitRows(box,
    [&](const Index3& first, Index count)
    {
      this->ReadMaterials(
        &block - this->Input.Blocks.data(), first, count, cells.Entry.data() + cells.CellId(first));
    });
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
        ReadRuns(this->Input.Blocks[b], this->Columns[b], first, count,
          [&](Index, Index length, Index label)
          { writer.AddLabel(this->MaterialOf(label), length); });
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

LevelCells OpenLabels(const std::vector<InputBlocks>& levels, const std::string& name, Ranks& ranks)
{
  LevelCells cells;
  std::vector<LabelCells*> opened;
  std::vector<int> labels;
  WorkTogether(ranks,
    [&]
    {
      for (const InputBlocks& level : levels)
      {
        auto own = std::make_unique<LabelCells>(level, name);
        const std::vector<int> found = own->FindLabels();
        labels.insert(labels.end(), found.begin(), found.end());
        opened.push_back(own.get());
        cells.push_back(std::move(own));
      }
    });
  labels = UnionOverRanks(ranks, std::move(labels));
  for (LabelCells* own : opened)
  {
    own->SetTable(labels);
  }
  return cells;
}

} // namespace vfm
