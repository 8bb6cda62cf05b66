#include "State/FineContents.h"

namespace vfm
{
namespace
{

constexpr int ChunkLevels = 3; // cells are summed in chunks of 2^ChunkLevels cells along each axis

/// Returns the weight of each column in sums over cells.
/// @param values values of a cell; volume: volume of the material in the cell
std::vector<double> FindWeights(const InputContents& contents, const double* values, double volume)
{
  const StatePlan& plan = contents.GetPlan();
  const double mass =
    plan.Density < 0 ? volume : volume * values[contents.FirstColumn(plan.Density)];
  std::vector<double> weights(contents.NumberOfColumns(), mass); // also for |u|^2 / 2
  for (std::size_t a = 0; a < plan.Conserved.size(); ++a)
  {
    const ConservedArray& array = plan.Conserved[a];
    const double factor =
      array.Weight < 0 ? mass : mass * values[contents.FirstColumn(array.Weight)];
    std::fill_n(weights.begin() + contents.FirstColumn(a), array.Components,
      array.Meaning == StateMeaning::PerMass ? factor : volume);
  }
  return weights;
}

} // namespace

void FineContents::Add(
  const IndexBox& box, int level, const std::function<void(const Index3&, int)>& visit)
{
  ForCells(ChangeLevel(box, -ChunkLevels),
    [&](const Index3& place)
    {
      const IndexBox chunk = Intersect(ChangeLevel(BoxOfCell(place), ChunkLevels), box);
      std::vector<std::vector<Sums>> sums(chunk.NumberOfCells());
      for (int finer = level + 1; finer <= this->Levels.Input.Finest(); ++finer)
      {
        this->AddLevel(chunk, level, finer, sums);
      }
      for (std::size_t i = 0; i < sums.size(); ++i)
      {
        if (!sums[i].empty())
        {
          visit(CellInBox(chunk, static_cast<Index>(i)), this->Store(sums[i]));
        }
      }
    });
}

/// Returns the source of each cell of a box of a level; null if no block of the level covers the
/// cell, or if a finer block does. Empty if there is no source.
std::vector<const StateBlock*> FineContents::FindSources(const IndexBox& box, int level) const
{
  std::vector<const StateBlock*> sources;
  for (const StateBlock& source : this->Levels.Values[level]->GetSources())
  {
    const IndexBox common = Intersect(source.Box, box);
    if (common.NumberOfCells() > 0)
    {
      sources.resize(box.NumberOfCells(), nullptr);
      ForCells(common, [&](const Index3& cell) { sources[IndexInBox(box, cell)] = &source; });
    }
  }
  if (!sources.empty() && level < this->Levels.Input.Finest())
  {
    const LevelCover cover(this->Levels.Input, level + 1, ChangeLevel(box, 1));
    ForCells(box,
      [&](const Index3& cell)
      {
        if (cover.Has(ChildOfCell(cell, 0)))
        {
          sources[IndexInBox(box, cell)] = nullptr;
        }
      });
  }
  return sources;
}

/// Adds the cells of a finer level, in an order that does not depend on the ranks that read them.
void FineContents::AddLevel(
  const IndexBox& chunk, int level, int finer, std::vector<std::vector<Sums>>& sums) const
{
  const IndexBox box = ChangeLevel(chunk, finer - level);
  const std::vector<const StateBlock*> sources = this->FindSources(box, finer);
  if (sources.empty())
  {
    return;
  }
  const CartesianGrid grid(this->Levels.Input.Levels[finer].Coordinates, box);
  const InputField field = this->Levels.Cells[finer]->MakeField(grid, this->Levels.Received[finer]);
  const FractionField& fractions = field.Fractions;
  ForCells(box,
    [&](const Index3& cell)
    {
      const StateBlock* source = sources[IndexInBox(box, cell)];
      if (!source)
      {
        return;
      }
      const Index at = grid.Linear(cell);
      const InputCell fine{ source, cell, grid.CellVolume(cell), &fractions, at };
      const Index3 whole = ChangeLevel(BoxOfCell(cell), level - finer).Lower;
      std::vector<Sums>& parts = sums[IndexInBox(chunk, whole)];
      fractions.ForParts(at,
        [&](int material, double fraction)
        { this->AddCell(fine, finer, fine.Volume * fraction, material, parts); });
    });
}

/// Adds a fine cell to the sums of a material; volume: volume of the material in the cell.
void FineContents::AddCell(
  const InputCell& cell, int level, double volume, int material, std::vector<Sums>& sums) const
{
  const std::size_t columns = this->Contents.NumberOfColumns();
  std::vector<double> values(columns);
  this->Contents.Read(cell, material, values.data());
  if (material >= this->FirstMaterial)
  {
    this->Contents.Check(values.data(), material, cell.Cell, level, this->Names);
  }
  auto at = std::find_if(
    sums.begin(), sums.end(), [material](const Sums& s) { return s.Material == material; });
  if (at == sums.end())
  {
    const std::vector<double> zeros(columns, 0.0);
    at = sums.insert(at, { material, 0.0, zeros, zeros, zeros });
  }
  const std::vector<double> weights = FindWeights(this->Contents, values.data(), volume);
  at->Volume += volume;
  for (std::size_t c = 0; c < columns; ++c)
  {
    at->Weights[c] += weights[c];
    at->Weighted[c] += weights[c] * values[c];
    at->Plain[c] += volume * values[c];
  }
}

int FineContents::Store(const std::vector<Sums>& sums)
{
  for (const Sums& own : sums)
  {
    this->Parts.push_back({ own.Material, this->Values.size() });
    for (std::size_t c = 0; c < own.Weights.size(); ++c)
    {
      this->Values.push_back(
        own.Weights[c] > 0.0 ? own.Weighted[c] / own.Weights[c] : own.Plain[c] / own.Volume);
    }
  }
  this->Offsets.push_back(this->Parts.size());
  return static_cast<int>(this->Offsets.size()) - 2;
}

void FineContents::Read(int number, int material, double* values) const
{
  const int columns = this->Contents.NumberOfColumns();
  for (std::size_t p = this->Offsets[number]; p < this->Offsets[number + 1]; ++p)
  {
    if (this->Parts[p].Material == material)
    {
      std::copy_n(this->Values.data() + this->Parts[p].First, columns, values);
      return;
    }
  }
  std::fill_n(values, columns, 0.0);
}

} // namespace vfm
