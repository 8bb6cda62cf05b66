#include "State/ConservedCells.h"

#include "Ranks/Agreement.h"

namespace vfm
{

ConservedCells::ConservedCells(const InputLevels& input, const LevelCells& cells,
  InputContents contents, const LevelFields& fields, int level, bool meshVoid,
  const std::vector<BlockPlace>& owners, Runtime& runtime) :
  Contents(std::move(contents)),
  Grid(fields.Grid),
  Fractions(fields.Field.Fractions),
  Names(fields.Field.Table.Names),
  Level(level),
  FirstMaterial(meshVoid ? 0 : 1),
  Levels{ input, cells, {},
    ExchangeState(input, this->Contents.GetStates(), level, owners, runtime.Group()) },
  Entry(fields.Grid, 0),
  Fine(this->Contents, this->Levels, this->Names, this->FirstMaterial)
{
  this->Receive(owners, runtime.Group());
  WorkTogether(runtime.Group(),
    [&]
    {
      this->MakeCoarseFields();
      this->PlaceSources();
      this->Fine.Add(this->Grid.Local(), this->Level,
        [this](const Index3& cell, int number)
        { this->Entry.Set(this->Grid.Linear(cell), ~number); });
      this->CheckOwned(runtime);
    });
}

/// Returns whether values are shared by the materials of an input cell, so that all its fractions
/// are needed.
bool ConservedCells::NeedsCoarseFields() const
{
  const std::vector<ConservedArray>& arrays = this->Contents.GetPlan().Conserved;
  return std::any_of(
    arrays.begin(), arrays.end(), [](const ConservedArray& array) { return array.IsShared(); });
}

/// Collective. Receives the fractions of finer levels, and of coarser levels if needed.
void ConservedCells::Receive(const std::vector<BlockPlace>& owners, Ranks& ranks)
{
  this->Levels.Received.resize(this->Levels.Input.Levels.size());
  for (int l = 0; l <= this->Levels.Input.Finest(); ++l)
  {
    if (l > this->Level || (l < this->Level && this->NeedsCoarseFields()))
    {
      this->Levels.Received[l] = ReceiveCells(ChangeLevel(owners, l), this->Levels.Input.Levels[l],
        *this->Levels.Cells[l], GhostLayersOn(l, this->Level), ranks);
    }
  }
}

void ConservedCells::MakeCoarseFields()
{
  for (int l = 0; l < this->Level && this->NeedsCoarseFields(); ++l)
  {
    CartesianGrid grid(
      this->Levels.Input.Levels[l].Coordinates, ChangeLevel(this->Grid.Local(), l - this->Level));
    InputField field = this->Levels.Cells[l]->MakeField(grid, this->Levels.Received[l]);
    this->Coarse.push_back(
      std::make_unique<CoarseField>(CoarseField{ std::move(grid), std::move(field) }));
  }
}

/// Sets the source of each cell, from coarse to fine, so that finer blocks replace coarser ones.
void ConservedCells::PlaceSources()
{
  int number = 0;
  for (int l = 0; l <= std::min(this->Level, this->Levels.Input.Finest()); ++l)
  {
    this->FirstSources.push_back(number);
    for (const StateBlock& source : this->Levels.Values[l]->GetSources())
    {
      const IndexBox box = Intersect(ChangeLevel(source.Box, this->Level - l), this->Grid.Local());
      ForRows(box,
        [&](Index j, Index k)
        {
          const Index first = this->Grid.Linear({ { box.Lower[0], j, k } });
          this->Entry.Fill(first, first + box.Size(0), number);
        });
      ++number;
    }
  }
}

int ConservedCells::LevelOf(int source) const
{
  const auto above = std::upper_bound(
    this->FirstSources.begin(), this->FirstSources.end(), static_cast<std::size_t>(source));
  return static_cast<int>(above - this->FirstSources.begin()) - 1;
}

InputCell ConservedCells::FindInput(const Index3& cell, int source) const
{
  const int level = this->LevelOf(source);
  InputCell found{ &this->Levels.Values[level]->GetSources()[source - this->FirstSources[level]],
    cell, 0.0, &this->Fractions, this->Grid.Linear(cell) };
  if (level == this->Level)
  {
    found.Volume = this->Grid.CellVolume(cell);
    return found;
  }
  found.Cell = ChangeLevel(BoxOfCell(cell), level - this->Level).Lower;
  if (!this->Coarse.empty())
  {
    const CoarseField& coarse = *this->Coarse[level];
    found.Volume = coarse.Grid.CellVolume(found.Cell);
    found.Fractions = &coarse.Field.Fractions;
    found.At = coarse.Grid.Linear(found.Cell);
  }
  return found;
}

void ConservedCells::Read(const Index3& cell, int material, double* values) const
{
  const int source = this->Entry[this->Grid.Linear(cell)];
  if (source < 0)
  {
    this->Fine.Read(~source, material, values);
    return;
  }
  this->Contents.Read(this->FindInput(cell, source), material, values);
}

/// Throws InputError for the first cell of a row with invalid values. Fine contents are
/// checked before.
void ConservedCells::CheckRow(Index j, Index k) const
{
  std::vector<double> values(this->Contents.NumberOfColumns());
  const IndexBox& owned = this->Grid.Owned();
  for (Index i = owned.Lower[0]; i < owned.Upper[0]; ++i)
  {
    const Index at = this->Grid.Linear({ { i, j, k } });
    const int source = this->Entry[at];
    const auto check = [&](int material, double)
    {
      if (source >= 0 && material >= this->FirstMaterial)
      {
        const InputCell cell = this->FindInput({ { i, j, k } }, source);
        const int level = this->Levels.Input.Finest() > 0 ? this->LevelOf(source) : -1;
        this->Contents.Read(cell, material, values.data());
        this->Contents.Check(values.data(), material, cell.Cell, level, this->Names);
      }
    };
    this->Fractions.ForParts(at, check);
  }
}

/// Checks the cells that this rank meshes; always reports the first invalid cell, on any number
/// of threads.
void ConservedCells::CheckOwned(Runtime& runtime) const
{
  const IndexBox& owned = this->Grid.Owned();
  std::vector<char> isSound(owned.NumberOfCells() > 0 ? owned.Size(1) * owned.Size(2) : 0, 1);
  ForRows(runtime, owned,
    [&](Index j, Index k, Index row)
    {
      try
      {
        this->CheckRow(j, k);
      }
      catch (const InputError&)
      {
        isSound[row] = 0;
      }
    });
  const auto wrong = std::find(isSound.begin(), isSound.end(), 0);
  if (wrong != isSound.end())
  {
    const Index row = wrong - isSound.begin();
    this->CheckRow(owned.Lower[1] + row % owned.Size(1), owned.Lower[2] + row / owned.Size(1));
  }
}

} // namespace vfm
