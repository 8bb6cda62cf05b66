#include "Levels/LevelSets.h"

#include "Base/ParseText.h"
#include "Fractions/LevelSetCell.h"
#include "Input/InputArrays.h"
#include "Input/PackBytes.h"
#include "Input/PlainArrays.h"
#include "Ranks/Agreement.h"
#include "Ranks/FindMeetings.h"

#include <cmath>
#include <limits>
#include <map>

namespace vfm
{
namespace
{

constexpr Index PartLayers = 32;        // layers of cells that are computed together
constexpr double Infinite = 1e100;      // in place of infinity
constexpr int NoValue = -1, Mixed = -2; // in place of the material of a centre
constexpr double Unknown = std::numeric_limits<double>::quiet_NaN();

/// Values of all arrays in a box of cells, array by array, x fastest.
struct BoxValues
{
  IndexBox Box;
  std::vector<double> Values;
};

/// The level sets of a level: of the blocks of this rank, and near them of other ranks.
class LevelValues
{
public:
  LevelValues(const InputBlocks& input, const LevelSetSource& source) :
    Input(input), Sign(source.IsPositiveInside ? -1.0 : 1.0), Count(source.Arrays.size())
  {
    for (const InputBlock& block : input.Blocks)
    {
      for (const std::string& name : source.Arrays)
      {
        this->Columns.emplace_back(FindMaterialArray(block, name));
      }
    }
  }

  std::size_t NumberOfArrays() const { return this->Count; }
  const InputBlocks& Blocks() const { return this->Input; }

  /// Returns the values of a box; NaN where there are none.
  BoxValues Read(const IndexBox& box) const
  {
    BoxValues found{ box, std::vector<double>(this->Count * box.NumberOfCells(), Unknown) };
    for (std::size_t b = 0; b < this->Input.Blocks.size(); ++b)
    {
      this->AddBlock(b, found);
    }
    for (const BoxValues& received : this->Received)
    {
      AddBox(received, found);
    }
    return found;
  }

  /// Returns the values of a block of this rank in a box.
  BoxValues ReadBlock(std::size_t block, const IndexBox& box) const
  {
    const IndexBox common = Intersect(this->Input.Blocks[block].Box, box);
    BoxValues found{ common, std::vector<double>(this->Count * common.NumberOfCells()) };
    this->AddBlock(block, found);
    return found;
  }

  void Receive(BoxValues values) { this->Received.push_back(std::move(values)); }

private:
  /// Reads the values of a block, with the sign that is negative inside; NaN in blanked cells.
  void AddBlock(std::size_t b, BoxValues& to) const
  {
    const InputBlock& block = this->Input.Blocks[b];
    const IndexBox common = Intersect(block.Box, to.Box);
    ForRows(common,
      [&](Index j, Index k)
      {
        const Index3 first{ { common.Lower[0], j, k } };
        for (std::size_t m = 0; m < this->Count; ++m)
        {
          double* row = to.Values.data() + m * to.Box.NumberOfCells() + IndexInBox(to.Box, first);
          ReadRow(block, this->Columns[b * this->Count + m], first, common.Size(0), row);
          for (Index i = 0; i < common.Size(0); ++i)
          {
            row[i] = IsHidden(block, block.CellId(first) + i) ? Unknown : this->Sign * row[i];
          }
        }
      });
  }

  static void AddBox(const BoxValues& from, BoxValues& to)
  {
    const IndexBox common = Intersect(from.Box, to.Box);
    const Index inFrom = from.Box.NumberOfCells(), inTo = to.Box.NumberOfCells();
    ForRows(common,
      [&](Index j, Index k)
      {
        const Index3 first{ { common.Lower[0], j, k } };
        for (Index at = IndexInBox(from.Box, first), put = IndexInBox(to.Box, first);
             at < static_cast<Index>(from.Values.size()); at += inFrom, put += inTo)
        {
          std::copy_n(from.Values.begin() + at, common.Size(0), to.Values.begin() + put);
        }
      });
  }

  const InputBlocks& Input;
  double Sign;
  std::size_t Count;
  std::vector<Column<double>> Columns; // arrays of each block
  std::vector<BoxValues> Received;
};

/// A block of a level.
struct PlacedBlock
{
  IndexBox Box;
  int Level;
};

/// Returns the cells whose values the fractions of a box depend on; some may be outside the grid.
IndexBox CellsAround(const IndexBox& box)
{
  IndexBox around = box;
  for (int a = 0; a < 3; ++a)
  {
    around.Lower[a] -= LevelSetLayers;
    around.Upper[a] += LevelSetLayers;
  }
  return around;
}

/// Exchanges values near the blocks of other ranks.
/// @pre Collective
void ExchangeValues(std::vector<LevelValues>& levels, Ranks& ranks)
{
  std::vector<PlacedBlock> own;
  for (std::size_t level = 0; level < levels.size(); ++level)
  {
    for (const InputBlock& block : levels[level].Blocks().Blocks)
    {
      own.push_back({ block.Box, static_cast<int>(level) });
    }
  }
  const auto boxes = [](const PlacedBlock& block)
  { return std::array<IndexBox, 1>{ { ChangeLevel(CellsAround(block.Box), -block.Level) } }; };
  const auto meet = [](const PlacedBlock& a, const PlacedBlock& b)
  { return a.Level == b.Level && Intersect(CellsAround(a.Box), b.Box).NumberOfCells() > 0; };
  std::map<int, Packer> messages;
  for (const RankItem<PlacedBlock>& other : FindMeetings(own, boxes, meet, ranks))
  {
    Packer& message = messages[other.Rank];
    const LevelValues& level = levels[other.What.Level];
    for (std::size_t b = 0; b < level.Blocks().Blocks.size(); ++b)
    {
      const BoxValues values = level.ReadBlock(b, CellsAround(other.What.Box));
      if (values.Box.NumberOfCells() > 0)
      {
        message.Add(other.What.Level);
        message.Add(values.Box);
        message.Add(values.Values);
      }
    }
  }
  std::vector<int> peers;
  std::vector<Bytes> outgoing;
  for (auto& [rank, message] : messages)
  {
    peers.push_back(rank);
    outgoing.push_back(std::move(message.Packed));
  }
  for (const Bytes& message : ranks.Exchange(peers, outgoing))
  {
    for (Unpacker unpacker(message); !unpacker.IsAtEnd();)
    {
      const int level = unpacker.Take<int>();
      BoxValues values{ unpacker.Take<IndexBox>(), {} };
      unpacker.TakeTo(values.Values);
      levels[level].Receive(std::move(values));
    }
  }
}

/// The fractions in a box of cells.
class PartFractions
{
public:
  PartFractions(const LevelValues& level, const IndexBox& box, LevelSetRule rule) :
    Level(level),
    Rule(rule),
    Around(level.Read(CellsAround(box))),
    Cells(Around.Box.NumberOfCells()),
    Materials(Cells)
  {
    for (Index cell = 0; cell < this->Cells; ++cell)
    {
      this->Materials[cell] = this->MaterialAt(cell);
    }
  }

  /// Finds the fraction of each material in a cell.
  void Find(const Index3& cell, std::vector<double>& fractions) const
  {
    const int material = this->OnlyMaterialAt(cell);
    fractions.assign(this->Level.NumberOfArrays(), material == NoValue ? Unknown : 0.0);
    if (material == Mixed)
    {
      this->FindMixed(cell, fractions);
    }
    else if (material > 0)
    {
      fractions[material - 1] = 1.0;
    }
  }

private:
  double Value(std::size_t array, Index cell) const
  {
    return this->Around.Values[array * this->Cells + cell];
  }

  /// Returns the material at the centre of a cell; NoValue if a value is NaN.
  int MaterialAt(Index cell) const
  {
    int first = 0, lowest = 1;
    for (std::size_t m = 0; m < this->Level.NumberOfArrays(); ++m)
    {
      const double value = this->Value(m, cell);
      if (std::isnan(value))
      {
        return NoValue;
      }
      first = first == 0 && value < 0.0 ? static_cast<int>(m) + 1 : first;
      lowest = value < this->Value(lowest - 1, cell) ? static_cast<int>(m) + 1 : lowest;
    }
    return this->Rule == LevelSetRule::Priority
      ? first
      : (this->Rule == LevelSetRule::Fill || first > 0 ? lowest : 0);
  }

  /// Returns the material of a cell if the cells around it have the same; NoValue if the cell has
  /// none, Mixed if the cells around it have another or none.
  int OnlyMaterialAt(const Index3& cell) const
  {
    const int material = this->Materials[IndexInBox(this->Around.Box, cell)];
    bool isMixed = false;
    ForCells({ { { cell[0] - 1, cell[1] - 1, cell[2] - 1 } },
               { { cell[0] + 2, cell[1] + 2, cell[2] + 2 } } },
      [&](const Index3& near)
      { isMixed = isMixed || this->Materials[IndexInBox(this->Around.Box, near)] != material; });
    return material != NoValue && isMixed ? Mixed : material;
  }

  /// Returns the values of an array around a cell. Infinite ones are extrapolated, unless that of
  /// the cell is.
  StencilValues ValuesAround(std::size_t array, const Index3& cell) const
  {
    StencilValues values{};
    const double own = this->Value(array, IndexInBox(this->Around.Box, cell));
    if (std::isinf(own))
    {
      values.fill(std::copysign(Infinite, own));
      return values;
    }
    int next = 0;
    ForCells(CellsAround(BoxOfCell(cell)),
      [&](const Index3& near)
      {
        const double value = this->Value(array, IndexInBox(this->Around.Box, near));
        values[next++] = std::isfinite(value) ? value : Unknown;
      });
    return values;
  }

  void FindMixed(const Index3& cell, std::vector<double>& fractions) const
  {
    const StencilPlaces places = PlacesAround(this->Level.Blocks().Coordinates, cell);
    std::vector<StencilValues> functions;
    for (std::size_t m = 0; m < fractions.size(); ++m)
    {
      functions.push_back(this->ValuesAround(m, cell));
      FillUnknown(places, functions.back());
    }
    const int material = FindOnlyMaterial(functions, this->Rule);
    if (material < 0)
    {
      fractions = FractionsOfFunctions(places, functions, this->Rule);
    }
    else if (material > 0)
    {
      fractions[material - 1] = 1.0;
    }
  }

  const LevelValues& Level;
  LevelSetRule Rule;
  BoxValues Around;
  Index Cells;
  std::vector<int> Materials; // at the centres of all cells around the box
};

/// Returns a block with the fractions of one block of a level.
InputBlock MakeBlock(
  const LevelValues& level, const InputBlock& block, const LevelSetSource& source, Runtime& runtime)
{
  const std::size_t count = source.Arrays.size();
  std::vector<Buffer<double>> values;
  for (std::size_t m = 0; m < count; ++m)
  {
    values.emplace_back(block.Box.NumberOfCells());
  }
  for (Index k = block.Box.Lower[2]; k < block.Box.Upper[2]; k += PartLayers)
  {
    IndexBox part = block.Box;
    part.Lower[2] = k;
    part.Upper[2] = std::min(k + PartLayers, block.Box.Upper[2]);
    const PartFractions found(level, part, source.Rule);
    ForRows(runtime, part,
      [&](Index j, Index layer, Index)
      {
        std::vector<double> fractions;
        for (Index3 cell{ { part.Lower[0], j, layer } }; cell[0] < part.Upper[0]; ++cell[0])
        {
          const bool isHidden = IsHidden(block, block.CellId(cell));
          found.Find(cell, fractions);
          for (std::size_t m = 0; m < count; ++m)
          {
            values[m][IndexInBox(block.Box, cell)] = isHidden ? 0.0 : fractions[m];
          }
        }
      });
  }
  const auto arrays = std::make_shared<PlainArrays>(block.Box.NumberOfCells());
  for (std::size_t m = 0; m < count; ++m)
  {
    arrays->Store(source.Arrays[m], ValueType::Double, std::move(values[m]));
  }
  InputBlock made = block;
  made.Arrays = arrays;
  made.Marks = nullptr;
  made.FirstCell = 0;
  KeepAllCells(made);
  return made;
}

/// Returns whether any value of a block is inside its material.
bool HasInside(const LevelValues& level, std::size_t block)
{
  const IndexBox& box = level.Blocks().Blocks[block].Box;
  bool isFound = false;
  for (Index k = box.Lower[2]; k < box.Upper[2] && !isFound; ++k)
  {
    IndexBox layer = box;
    layer.Lower[2] = k;
    layer.Upper[2] = k + 1;
    const std::vector<double> values = level.ReadBlock(block, layer).Values;
    isFound = std::any_of(values.begin(), values.end(), [](double v) { return !(v >= 0.0); });
  }
  return isFound;
}

/// Checks that some value is inside its material.
/// @pre Collective
void CheckInside(const std::vector<LevelValues>& levels, const LevelSetSource& source, Ranks& ranks)
{
  bool isFound = source.Rule == LevelSetRule::Fill;
  for (const LevelValues& level : levels)
  {
    for (std::size_t b = 0; b < level.Blocks().Blocks.size() && !isFound; ++b)
    {
      isFound = HasInside(level, b);
    }
  }
  if (ranks.Any(isFound))
  {
    return;
  }
  std::vector<std::string> names;
  for (const std::string& name : source.Arrays)
  {
    names.push_back("'" + name + "'");
  }
  throw InputError(std::string("No value of the level set ") + JoinTexts(names) + " is " +
    (source.IsPositiveInside ? "positive" : "negative") +
    ", so no cell is inside a material. LevelSetInside " +
    (source.IsPositiveInside ? "Negative" : "Positive") +
    " (--level-set-inside) takes the other sign; LevelSets Off is for volume fractions.");
}

} // namespace

std::vector<InputBlocks> FractionsOfLevelSets(
  const std::vector<InputBlocks>& levels, const LevelSetSource& source, Runtime& runtime)
{
  Ranks& ranks = runtime.Group();
  std::vector<LevelValues> values;
  WorkTogether(ranks,
    [&]
    {
      for (const InputBlocks& level : levels)
      {
        values.emplace_back(level, source);
      }
    });
  CheckInside(values, source, ranks);
  ExchangeValues(values, ranks);
  std::vector<InputBlocks> made = levels;
  WorkTogether(ranks,
    [&]
    {
      for (std::size_t level = 0; level < levels.size(); ++level)
      {
        for (InputBlock& block : made[level].Blocks)
        {
          block = MakeBlock(values[level], block, source, runtime);
        }
      }
    });
  return made;
}

} // namespace vfm
