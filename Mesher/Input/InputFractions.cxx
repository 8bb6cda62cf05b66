#include "Input/InputFractions.h"

#include "Input/FractionChecks.h"
#include "Input/InputArrays.h"
#include "Ranks/Agreement.h"

#include <cmath>
#include <functional>
#include <limits>

namespace vfm
{
namespace
{

constexpr double ByteRounding = 0.50001 / 255; // rounding of fractions stored as unsigned char
constexpr double NotAccepted = -std::numeric_limits<double>::infinity();

class FractionCells : public InputCells
{
public:
  /// areMasks: 1 is full in arrays of type unsigned char, not 255.
  FractionCells(const InputBlocks& input, const std::vector<std::string>& names, bool areMasks,
    double tolerance) :
    InputCells(input), Names(names), OutsideTolerance(tolerance), Bytes(names.size(), 0)
  {
    for (const InputBlock& block : input.Blocks)
    {
      for (std::size_t m = 0; m < names.size(); ++m)
      {
        const auto found = FindMaterialArray(block, names[m]);
        const auto array = areMasks ? ViewMask(found) : found;
        this->Bytes[m] += array->Type == ValueType::UnsignedChar;
        this->Columns.emplace_back(array);
      }
    }
  }

  /// Number of arrays of type unsigned char of each material. Set to the sum over all ranks,
  /// because a rank may receive values that another rank stores as unsigned char.
  const std::vector<Index>& GetBytes() const { return this->Bytes; }
  void SetBytes(std::vector<Index> bytes) { this->Bytes = std::move(bytes); }
  /// Returns the rounding error of fractions of type unsigned char: 128 + 128 is 256 / 255.
  double Rounding(int material) const { return this->Bytes[material - 1] > 0 ? ByteRounding : 0.0; }

  double Tolerance() const { return this->OutsideTolerance; }

  /// Finds the cells of this rank whose fractions, if each is accepted, sum to more than accepted.
  /// @param[out] outside  fractions that are not accepted
  OverfullCells FindOverfull(OutsideFractions& outside) const;
  Index NumberOfCells() const;

  SparseCells Extract(std::size_t block, const IndexBox& box) const override;
  InputField MakeField(
    const CartesianGrid& grid, const std::vector<SparseCells>& received) const override;

  int NumberOfMaterials() const { return static_cast<int>(this->Names.size()); }
  const std::string& Name(int material) const { return this->Names[material - 1]; }
  const std::vector<InputBlock>& Blocks() const { return this->Input.Blocks; }
  void ReadFractions(
    std::size_t block, int material, const Index3& first, Index count, double* values) const
  {
    ReadRow(this->Blocks()[block], this->Columns[block * this->Names.size() + material - 1], first,
      count, values);
  }

protected:
  void ReadMaterials(
    std::size_t block, const Index3& first, Index count, int* materials) const override;

private:
  std::vector<std::string> Names;
  double OutsideTolerance;
  std::vector<Index> Bytes;
  std::vector<Column<double>> Columns; // materials of each block
};

/// Reads rows of the local box from the blocks of this rank and from received boxes.
class LocalReader : public FractionField::Reader
{
public:
  LocalReader(const CartesianGrid& grid, const FractionCells& cells,
    const std::vector<SparseCells>& received) :
    Cells(cells), Received(received), Lowest(grid.Local().Lower[2]), Layers(grid.Local().Size(2))
  {
    for (std::size_t b = 0; b < cells.Blocks().size(); ++b)
    {
      this->AddSource(cells.Blocks()[b].Box, b, grid.Local());
    }
    for (std::size_t r = 0; r < received.size(); ++r)
    {
      this->AddSource(received[r].Box, cells.Blocks().size() + r, grid.Local());
    }
  }

  void Read(int material, const Index3& first, Index count, double* values) const override
  {
    std::fill_n(values, count, 0.0);
    for (const Source& source : this->Layers[first[2] - this->Lowest])
    {
      const Index begin = std::max(first[0], source.Box.Lower[0]);
      const Index end = std::min(first[0] + count, source.Box.Upper[0]);
      if (first[1] >= source.Box.Lower[1] && first[1] < source.Box.Upper[1] && begin < end)
      {
        this->ReadSource(source, material, { { begin, first[1], first[2] } }, end - begin,
          values + (begin - first[0]));
      }
    }
  }
  double Rounding(int material) const override { return this->Cells.Rounding(material); }
  double Tolerance() const override { return this->Cells.Tolerance(); }
  std::string Name(int material) const override { return this->Cells.Name(material); }

private:
  struct Source
  {
    IndexBox Box;
    std::size_t Number; // number of the block, or number of blocks + number of the received box
  };

  void AddSource(const IndexBox& box, std::size_t number, const IndexBox& local)
  {
    const IndexBox common = Intersect(box, local);
    for (Index k = common.Lower[2]; common.NumberOfCells() > 0 && k < common.Upper[2]; ++k)
    {
      this->Layers[k - this->Lowest].push_back({ common, number });
    }
  }

  void ReadSource(
    const Source& source, int material, const Index3& first, Index count, double* values) const
  {
    const std::size_t blocks = this->Cells.Blocks().size();
    if (source.Number < blocks)
    {
      this->Cells.ReadFractions(source.Number, material, first, count, values);
      return;
    }
    const SparseCells& box = this->Received[source.Number - blocks];
    const Index cell = box.CellId(first);
    for (Index c = 0; c < count; ++c)
    {
      values[c] = box.Fraction(cell + c, material);
    }
  }

  const FractionCells& Cells;
  const std::vector<SparseCells>& Received;
  Index Lowest;
  std::vector<std::vector<Source>> Layers; // sources of each layer of cells along z
};

void FractionCells::ReadMaterials(
  std::size_t block, const Index3& first, Index count, int* materials) const
{
  std::vector<double> values(count);
  std::fill_n(materials, count, 0);
  for (int m = 1; m <= this->NumberOfMaterials(); ++m)
  {
    this->ReadFractions(block, m, first, count, values.data());
    for (Index c = 0; c < count; ++c)
    {
      if (values[c] != 0.0) // NaN too
      {
        materials[c] = materials[c] == 0 && values[c] == 1.0 ? m : Mixed;
      }
    }
  }
}

OverfullCells FractionCells::FindOverfull(OutsideFractions& outside) const
{
  double most = this->OutsideTolerance;
  for (int m = 1; m <= this->NumberOfMaterials(); ++m)
  {
    most += this->Rounding(m);
  }
  most = 1.0 + std::max(SumTolerance, most);
  OverfullCells found;
  std::vector<double> values, sums;
  for (std::size_t b = 0; b < this->Blocks().size(); ++b)
  {
    const IndexBox& box = this->Blocks()[b].Box;
    values.resize(box.Size(0));
    ForRows(box,
      [&](Index j, Index k)
      {
        const Index3 first{ { box.Lower[0], j, k } };
        sums.assign(box.Size(0), 0.0);
        for (int m = 1; m <= this->NumberOfMaterials(); ++m)
        {
          this->ReadFractions(b, m, first, box.Size(0), values.data());
          for (Index c = 0; c < box.Size(0); ++c)
          {
            const double distance = std::max(-values[c], values[c] - 1.0); // or NaN
            const bool isAccepted = distance <= this->OutsideTolerance;
            sums[c] += isAccepted ? std::clamp(values[c], 0.0, 1.0) : NotAccepted;
            if (distance > this->OutsideTolerance)
            {
              const double lowest = std::isfinite(values[c]) ? std::min(values[c], 0.0) : 0.0;
              outside.Add({ distance, values[c], m, { { first[0] + c, j, k } }, lowest, m });
            }
          }
        }
        for (Index c = 0; this->NumberOfMaterials() > 1 && c < box.Size(0); ++c)
        {
          if (sums[c] > most)
          {
            found.Add({ 1, sums[c], sums[c], { { first[0] + c, j, k } } });
          }
        }
      });
  }
  return found;
}

Index FractionCells::NumberOfCells() const
{
  Index cells = 0;
  for (const InputBlock& block : this->Blocks())
  {
    cells += block.Box.NumberOfCells();
  }
  return cells;
}

SparseCells FractionCells::Extract(std::size_t block, const IndexBox& box) const
{
  struct Item
  {
    int Material;
    double Value;
  };
  SparseCells cells;
  cells.Box = box;
  std::vector<double> values(box.Size(0));
  std::vector<std::vector<Item>> row(box.Size(0));
  ForRows(box,
    [&](Index j, Index k)
    {
      for (int m = 1; m <= this->NumberOfMaterials(); ++m)
      {
        this->ReadFractions(block, m, { { box.Lower[0], j, k } }, box.Size(0), values.data());
        for (Index c = 0; c < box.Size(0); ++c)
        {
          if (values[c] != 0.0) // NaN too
          {
            row[c].push_back({ m, values[c] });
          }
        }
      }
      for (std::vector<Item>& items : row)
      {
        cells.AddCell(items);
        items.clear();
      }
    });
  return cells;
}

InputField FractionCells::MakeField(
  const CartesianGrid& grid, const std::vector<SparseCells>& received) const
{
  const int count = this->NumberOfMaterials();
  Materials table{ { "Void" }, { 0 }, 0 };
  for (int m = 1; m <= count; ++m)
  {
    table.Names.push_back(this->Name(m));
    table.Labels.push_back(m);
  }
  const LocalReader reader(grid, *this, received);
  InputField field{ FractionField::FromReader(grid, count, reader), std::move(table), {} };
  field.Corrected = { field.Fractions.NumberOfNormalisedCells(),
    field.Fractions.NumberOfClippedCells() };
  return field;
}

} // namespace

LevelCells OpenFractions(const std::vector<InputBlocks>& levels,
  const std::vector<std::string>& names, double tolerance, const std::string& labelsOption,
  Ranks& ranks)
{
  LevelCells cells;
  std::vector<FractionCells*> opened;
  std::vector<Index> bytes(names.size(), 0);
  const bool areMasks = AreMasks(levels, names, labelsOption, ranks);
  WorkTogether(ranks,
    [&]
    {
      for (const InputBlocks& level : levels)
      {
        auto own = std::make_unique<FractionCells>(level, names, areMasks, tolerance);
        std::transform(
          bytes.begin(), bytes.end(), own->GetBytes().begin(), bytes.begin(), std::plus<>());
        opened.push_back(own.get());
        cells.push_back(std::move(own));
      }
    });
  ranks.Sum(bytes);
  for (FractionCells* own : opened)
  {
    own->SetBytes(bytes);
  }
  OverfullCells overfull;
  OutsideFractions outside;
  Index count = 0;
  WorkTogether(ranks,
    [&]
    {
      for (const FractionCells* own : opened)
      {
        overfull.Add(own->FindOverfull(outside));
        count += own->NumberOfCells();
      }
    });
  CheckOutside(outside, names, ranks);
  CheckSums(overfull, count, ranks);
  return cells;
}

} // namespace vfm
