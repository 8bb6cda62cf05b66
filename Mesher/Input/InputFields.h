/**
 * InputFields: the materials in the cells of the input, and their exchange between the ranks that
 * read cells and the ranks that mesh them. Materials are given by one volume fraction array per
 * material (InputFractions.h) or by one array of labels (InputLabels.h).
 */
#pragma once

#include "Fractions/FractionField.h"
#include "Input/InputBlocks.h"
#include "Input/SparseCells.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace vfm
{

/// The materials of a field, indexed by material number of the folder Grid: 0 void, 1..N materials.
struct Materials
{
  std::vector<std::string> Names;
  std::vector<int> Labels; ///< ids of the user; 0 is void
  int ZeroId = 0;          ///< id of the material with label 0 in the input; 0: it is void
};

/// Returns the names of materials by id.
inline std::map<int, std::string> NamesOf(const Materials& table)
{
  std::map<int, std::string> names;
  for (std::size_t m = 0; m < table.Names.size(); ++m)
  {
    names[table.Labels[m]] = table.Names[m];
  }
  return names;
}

/// Numbers of cells of the input that were changed.
struct CorrectedCells
{
  Index Normalised = 0; ///< cells whose fractions summed to more than 1 and were scaled back
  Index Clipped = 0;    ///< cells with a fraction outside [0, 1] that was clipped

  void Add(const CorrectedCells& other)
  {
    this->Normalised += other.Normalised;
    this->Clipped += other.Clipped;
  }
};

/// The materials in the cells of a grid.
struct InputField
{
  FractionField Fractions; ///< volume fractions in the local box of the grid
  Materials Table;         ///< equal on all ranks
  CorrectedCells Corrected;
};

/// The materials in the cells of this rank's blocks. No member communicates.
class InputCells
{
public:
  virtual ~InputCells() = default;

  /// Returns the cells that are mixed, or differ from the previous cell of the block along
  /// any axis.
  std::vector<Index3> FindInterfaceCells() const;

  /// Extracts the cells of a box that lies within a block, by its place in the blocks of this rank.
  virtual SparseCells Extract(std::size_t block, const IndexBox& box) const = 0;

  /// Makes the field of the local box of a grid.
  /// Values come from the arrays of this rank, else from received cells; other cells are void.
  /// @return Corrected counts owned cells only
  /// @throws InputError if values are not fractions
  virtual InputField MakeField(
    const CartesianGrid& grid, const std::vector<SparseCells>& received) const = 0;

protected:
  explicit InputCells(const InputBlocks& input) : Input(input) {}

  /// Finds the material of each cell of a row of a block; Mixed if a cell has several.
  static constexpr int Mixed = -1;
  virtual void ReadMaterials(
    std::size_t block, const Index3& first, Index count, int* materials) const = 0;

  const InputBlocks& Input;
};

/// The materials in the blocks of each level.
using LevelCells = std::vector<std::unique_ptr<InputCells>>;

/// Receives the cells that this rank meshes, with ghost cells, from the blocks of other ranks.
/// @param owners cells that each rank meshes, of all ranks or of nearby ranks
/// @pre Collective
std::vector<SparseCells> ReceiveCells(const std::vector<BlockPlace>& owners,
  const InputBlocks& input, const InputCells& cells, Index ghostLayers, Ranks& ranks);

} // namespace vfm
