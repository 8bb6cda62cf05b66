/**
 * FineContents: what cells of a grid hold where blocks of finer levels of the input cover them: means of the fine cells, each weighted with
 * its volume or mass of the material, so that their sums are those of the fine cells.
 */
#pragma once

#include "Input/InputFields.h"
#include "Input/InputLevels.h"
#include "State/InputContents.h"

#include <functional>

namespace vfm
{

/// What is known of the input's levels on this rank.
struct LevelsOfState
{
  const InputLevels& Input;
  const LevelCells& Cells;
  std::vector<std::vector<SparseCells>>
    Received; ///< of each level: fractions in blocks of other ranks
  StateValues Values;
};

class FineContents
{
public:
  /// All must outlive this. names: of the materials; those from firstMaterial on are checked.
  FineContents(const InputContents& contents, const LevelsOfState& levels,
    const std::vector<std::string>& names, int firstMaterial) :
    Contents(contents), Levels(levels), Names(names), FirstMaterial(firstMaterial)
  {
  }

  /// Adds the cells of a box of some level that finer blocks cover; visit(cell, number) is called for each.
  void Add(const IndexBox& box, int level, const std::function<void(const Index3&, int)>& visit);

  /// Of a material in the cell with a number; zeros where there is none of it.
  void Read(int number, int material, double* values) const;

private:
  /// Sums over fine cells of what one cell holds of a material.
  struct Sums
  {
    int Material;
    double Volume = 0.0;
    std::vector<double> Weights;         // of each column
    std::vector<double> Weighted, Plain; // values times these, times volumes
  };
  struct Part
  {
    int Material;
    std::size_t First; // of Values
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
  std::vector<std::size_t> Offsets{ 0 }; // of each number in Parts, and the end
  std::vector<Part> Parts;
  std::vector<double> Values;
};

} // namespace vfm
