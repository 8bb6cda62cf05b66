#include "State/FineContents.h"

namespace vfm
{
namespace
{

constexpr int ChunkLevels = 3; // cells are summed in chunks of 2^ChunkLevels cells along each axis

} // namespace

void FineContents::Add(
  const IndexBox& box, int level, const std::function<void(const Index3&, int)>& visit)
{
  ForCells(ChangeLevel(box, -ChunkLevels),
    [&](const Index3& place)
    {
      const IndexBox chunk = Intersect(ChangeLevel(BoxOfCell(place), ChunkLevels), box);
      std::vector<ContentSums> sums(chunk.NumberOfCells());
      for (int finer = level + 1; finer <= this->Levels.Input.Finest(); ++finer)
      {
        this->AddLevel(chunk, level, finer, sums);
      }
      for (std::size_t i = 0; i < sums.size(); ++i)
      {
        if (!sums[i].IsEmpty())
        {
          visit(CellInBox(chunk, static_cast<Index>(i)), this->Means.Store(sums[i]));
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
  const IndexBox& chunk, int level, int finer, std::vector<ContentSums>& sums) const
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
      ContentSums& parts = sums[IndexInBox(chunk, whole)];
      fractions.ForParts(at,
        [&](int material, double fraction)
        { this->AddCell(fine, finer, fine.Volume * fraction, material, parts); });
    });
}

/// Adds a fine cell to the sums of a material; volume: volume of the material in the cell.
void FineContents::AddCell(
  const InputCell& cell, int level, double volume, int material, ContentSums& sums) const
{
  std::vector<double> values(this->Contents.NumberOfColumns());
  this->Contents.Read(cell, material, values.data());
  if (material >= this->FirstMaterial)
  {
    this->Contents.Check(values.data(), material, cell.Cell, level, this->Names);
  }
  sums.Add(this->Contents, material, volume, values.data());
}

} // namespace vfm
