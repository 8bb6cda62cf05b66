/**
 * The materials in the cells of the input, given by either one volume fraction array a material or one array
 * of labels, and their way from the ranks that read them to the ranks that mesh them.
 */
#pragma once

#include "Fractions/FractionField.h"
#include "Input/InputBlocks.h"
#include "Input/SparseCells.h"

#include <memory>
#include <string>
#include <vector>

namespace vfm
{

/// The materials of a field, by their number in the Grid code: 0 is void, 1..N the materials.
struct Materials
{
  std::vector<std::string> Names;
  std::vector<int> Labels; ///< what the user calls them; 0 is void
};

/// How many cells of the input were changed.
struct CorrectedCells
{
  Index Normalised = 0; ///< the sum of their fractions exceeded 1 and was scaled back
  Index Clipped = 0;    ///< a fraction lay outside [0, 1] and was clipped

  void Add(const CorrectedCells& other)
  {
    this->Normalised += other.Normalised;
    this->Clipped += other.Clipped;
  }
};

struct InputField
{
  FractionField Fractions; ///< of the grid's local box
  Materials Table;         ///< the same on all ranks
  CorrectedCells Corrected;
};

/// What the arrays of this rank's blocks hold. Nothing here communicates.
class InputCells
{
public:
  virtual ~InputCells() = default;

  /// The cells that are mixed, or differ from the cell before them along an axis of their block.
  std::vector<Index3> FindInterfaceCells() const;

  /// The cells of a box that lies within a block.
  virtual SparseCells Extract(const InputBlock& block, const IndexBox& box) const = 0;

  /// The field of the local box: from the arrays where this rank has them, else from what it received, void where nobody has;
  /// those mended are counted among the owned ones. Throws InputError on values that are no fractions.
  virtual InputField MakeField(
    const CartesianGrid& grid, const std::vector<SparseCells>& received) const = 0;

protected:
  explicit InputCells(const InputBlocks& input) : Input(input) {}

  /// The materials of a row of cells of a block; Mixed where it has not just one.
  static constexpr int Mixed = -1;
  virtual void ReadMaterials(
    std::size_t block, const Index3& first, Index count, int* materials) const = 0;

  const InputBlocks& Input;

private:
  void FindInterfaceCells(std::size_t block, std::vector<Index3>& found) const;
};

/// Of the blocks of each level.
using LevelCells = std::vector<std::unique_ptr<InputCells>>;

/// Collective: what the cells that this rank meshes, and ghost cells around them, need of the blocks of other ranks. owners: the
/// cells that the ranks mesh, of all ranks or those near.
std::vector<SparseCells> ReceiveCells(const std::vector<BlockPlace>& owners,
  const InputBlocks& input, const InputCells& cells, Index ghostLayers, Ranks& ranks);

} // namespace vfm
