/**
 * ConservedCells: the state of each material in the cells of the donor grid.
 *
 * The donor grid has the fractions as read, before regions are removed, labels smoothed or cells
 * divided. Its level is the finest of the input, or the finest of the mesh if that is coarser. A
 * cell of a coarser level of the input is several cells of the grid. Where the input is finer,
 * FineContents has means.
 */
#pragma once

#include "Base/PagedArray.h"
#include "Levels/LevelFields.h"
#include "State/FineContents.h"
#include "State/Transfer/TransferState.h"

namespace vfm
{

/// The state of each material in the local box of a donor grid. Read() may be called by several
/// threads.
class DonorCells : public StateCellValues
{
public:
  virtual const CartesianGrid& GetGrid() const = 0;
  /// Returns the level of the grid.
  virtual int GetLevel() const = 0;
  /// Returns the fractions as read, before regions are removed or labels smoothed.
  virtual const FractionField& GetFractions() const = 0;
  virtual const InputContents& GetContents() const = 0;
};

/// State in the cells of the input.
class ConservedCells : public DonorCells
{
public:
  /// Receives the values of cells from all ranks and checks the owned ones.
  /// @param input,cells must outlive this object
  /// @param fields result of MakeLevelFields; its grid and fractions are copied
  /// @param level level of that grid
  /// @param owners cells of level 0 that each rank meshes
  /// @throws InputError if a material (also void, if meshed) has values that are not finite, or a
  /// density below 0; on all ranks
  /// @pre Collective
  ConservedCells(const InputLevels& input, const LevelCells& cells, InputContents contents,
    const LevelFields& fields, int level, bool meshVoid, const std::vector<BlockPlace>& owners,
    Runtime& runtime);
  ConservedCells(const ConservedCells&) = delete;
  ConservedCells& operator=(const ConservedCells&) = delete;

  const CartesianGrid& GetGrid() const override { return this->Grid; }
  int GetLevel() const override { return this->Level; }
  const FractionField& GetFractions() const override { return this->Fractions; }
  const InputContents& GetContents() const override { return this->Contents; }

  void Read(const Index3& cell, int material, double* values) const override;

private:
  /// Fractions of the input on a level coarser than the grid.
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
  const std::vector<std::string> Names; // names of the materials
  const int Level, FirstMaterial;
  LevelsOfState Levels;
  std::vector<std::size_t>
    FirstSources;        // number of the first source of each level up to Level, and the end
  PagedArray<int> Entry; // source of each cell, or ~(number in Fine)
  FineContents Fine;
  std::vector<std::unique_ptr<CoarseField>> Coarse; // fields of levels below Level, if needed
};

} // namespace vfm
