/**
 * FineContents: the state of cells below finer blocks of the input: means over the fine cells,
 * weighted by volume or mass of the material, so that sums are conserved.
 */
#pragma once

#include "Input/InputFields.h"
#include "Input/InputLevels.h"
#include "State/InputContents.h"

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
  void Read(int number, int material, double* values) const;

private:
  /// Sums of a material over the fine cells in one cell.
  struct Sums
  {
    int Material;
    double Volume = 0.0;
    std::vector<double> Weights;         // sum of weights, by column
    std::vector<double> Weighted, Plain; // sums of values times weights, and times volumes
  };
  /// A material in a cell.
  struct Part
  {
    int Material;
    std::size_t First; // index of its first column in Values
  };

  void AddLevel(
    const IndexBox& chunk, int level, int finer, std::vector<std::vector<Sums>>& sums) const;
  std::vector<const StateBlock*> FindSources(const IndexBox& box, int level) const;
  void AddCell(
    const InputCell& cell, int level, double volume, int material, std::vector<Sums>& sums) const;
  int Store(const std::vector<Sums>& sums);

  const InputContents& Contents;
  const LevelsOfState& Levels;
  const std::vector<std::string>& Names;
  const int FirstMaterial;
  std::vector<std::size_t> Offsets{ 0 }; // index of each number in Parts, and the end
  std::vector<Part> Parts;
  std::vector<double> Values;
};

} // namespace vfm
