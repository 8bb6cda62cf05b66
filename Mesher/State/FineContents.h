/**
 * FineContents: the state of cells below finer blocks of the input: means over the fine cells,
 * weighted by volume or mass of the material, so that sums are conserved.
 */
#pragma once

#include "Input/InputFields.h"
#include "Input/InputLevels.h"
#include "State/InputContents.h"
#include "State/MeanContents.h"

#include <functional>

namespace vfm
{

/// The levels of the input on this rank, with received cells.
struct LevelsOfState
{
  const InputLevels& Input;
  const LevelCells& Cells;
  std::vector<std::vector<SparseCells>> Received; ///< fractions from other ranks, by level
  StateValues Values;
};

/// Stores the state of cells that Add() has visited, by number.
class FineContents
{
public:
  /// All references must outlive this object.
  /// @param names names of the materials
  /// @param firstMaterial first material whose values are checked
  FineContents(const InputContents& contents, const LevelsOfState& levels,
    const std::vector<std::string>& names, int firstMaterial) :
    Contents(contents), Levels(levels), Names(names), FirstMaterial(firstMaterial)
  {
  }

  /// Adds the cells of a box of a level below finer blocks; calls visit(cell, number) for each.
  void Add(const IndexBox& box, int level, const std::function<void(const Index3&, int)>& visit);

  /// Reads the values of a material in the cell with a number; zeros if the cell lacks
  /// the material.
  void Read(int number, int material, double* values) const
  {
    this->Means.Read(number, material, this->Contents.NumberOfColumns(), values);
  }

private:
  void AddLevel(const IndexBox& chunk, int level, int finer, std::vector<ContentSums>& sums) const;
  std::vector<const StateBlock*> FindSources(const IndexBox& box, int level) const;
  void AddCell(
    const InputCell& cell, int level, double volume, int material, ContentSums& sums) const;

  const InputContents& Contents;
  const LevelsOfState& Levels;
  const std::vector<std::string>& Names;
  const int FirstMaterial;
  MeanContents Means;
};

} // namespace vfm
