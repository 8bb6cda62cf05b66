/**
 * ConservedCells: what the cells of the grid that gives hold of each material.
 *
 * The grid is that of the fractions as they were read, before anything was removed, smoothed or cut: of the finest level of the input,
 * or of the finest cells of the mesh where these are larger. A cell of a coarser level of the input is several of its cells; where the
 * input is finer FineContents has the means.
 */
#pragma once

#include "Base/PagedArray.h"
#include "Levels/LevelFields.h"
#include "State/FineContents.h"
#include "Transfer/TransferState.h"

namespace vfm
{

class ConservedCells : public StateCellValues
{
public:
  /// Collective. fields: as MakeLevelFields made them, whose grid and fractions are copied; level: of that grid; cells: of the input;
  /// owners: the cells of level 0 that the ranks mesh. input and cells must outlive this. Throws InputError, on all ranks alike,
  /// where a material, or void if it is meshed, has values that are no numbers, or a density below 0.
  ConservedCells(const InputLevels& input, const LevelCells& cells, InputContents contents,
    const LevelFields& fields, int level, bool meshVoid, const std::vector<BlockPlace>& owners,
    Runtime& runtime);
  ConservedCells(const ConservedCells&) = delete;
  ConservedCells& operator=(const ConservedCells&) = delete;

  const CartesianGrid& GetGrid() const { return this->Grid; }
  const FractionField& GetFractions() const { return this->Fractions; }
  const InputContents& GetContents() const { return this->Contents; }

  void Read(const Index3& cell, int material, double* values) const override;

private:
  /// Fractions of the input's own cells, on a level coarser than the grid.
  struct CoarseField
  {
    CartesianGrid Grid;
    InputField Field;
  };

  void Receive(const std::vector<BlockPlace>& owners, Ranks& ranks);
  void MakeCoarseFields();
  void PlaceSources();
  bool NeedsCoarseFields() const;
  int LevelOf(int source) const;
  InputCell FindInput(const Index3& cell, int source) const;
  void CheckOwned(Runtime& runtime) const;
  void CheckRow(Index j, Index k) const;

  const InputContents Contents;
  const CartesianGrid Grid;
  const FractionField Fractions;
  const std::vector<std::string> Names; // of the materials
  const int Level, FirstMaterial;
  LevelsOfState Levels;
  std::vector<std::size_t>
    FirstSources;        // of each level up to Level among their sources, and the end
  PagedArray<int> Entry; // of each cell its source, or ~(number among the fine contents)
  FineContents Fine;
  std::vector<std::unique_ptr<CoarseField>> Coarse; // of each level below Level, where needed
};

} // namespace vfm
