/**
 * HostBlocks: the blocks of cells, with their fields, that a host passes on one rank through the C
 * interface.
 */
#pragma once

#include "PlaceHostBoxes.h"

#include <optional>

namespace vfm
{

/// Name and components of an array.
struct FieldName
{
  std::string Name;
  int Components;
  bool operator==(const FieldName& other) const
  {
    return this->Name == other.Name && this->Components == other.Components;
  }
};

/// Names of the fields of a block, which must be equal in all blocks of all ranks.
struct FieldNames
{
  std::vector<FieldName> Materials, States;
  bool HasMaterialIds = false; ///< MaterialIdName replaces Materials
};

/// Name of the array of material ids.
constexpr const char* MaterialIdName = "MaterialIds";

/// Blocks of one rank. The values of fields belong to the host.
class HostBlocks
{
public:
  ///@{ The arguments are copied; Check checks them.
  /// Sets the cells of the first block, on level 0. It keeps its fields; other blocks are removed.
  /// @param bounds  xmin ymin zmin xmax ymax zmax
  /// @param intervals  numbers of cells along x, y, z
  void SetOnly(const double* bounds, const int* intervals);
  /// Adds a block, to which the fields added next belong.
  void Begin(int level, const double* bounds, const int* intervals);
  ///@}
  void Clear() { this->Blocks.clear(); }

  ///@{ Adds values of the cells of the last block. If there are no blocks yet, they belong to the
  /// block that SetOnly will set. Values are not copied.
  void AddMaterial(const std::string& name, const double* fractions);
  void AddState(const std::string& name, int components, const double* values);
  void SetMaterialIds(const int* ids);
  ///@}
  /// Removes the fields of all blocks.
  void ClearFields();

  /// Returns whether this rank has one block of level 0, which face neighbours require.
  bool IsOneBox() const { return this->Blocks.size() == 1 && this->Blocks[0].Cells->Level == 0; }
  std::size_t Count() const { return this->Blocks.size(); }

  /// Checks the blocks of this rank. Not collective.
  /// @throws InputError  if CheckBoundedCells rejects a block, or if a block has no cells, no
  ///   fields, or other fields than the first block
  void Check() const;
  /// Returns the names of fields, also on ranks without blocks.
  /// @throws InputError  on ranks whose names differ from the first rank with blocks; on all ranks
  ///   if there are no blocks
  /// @pre Collective, after Check
  FieldNames AgreeOnNames(Ranks& ranks) const;
  /// Returns the blocks with their fields, placed in the grid of all ranks (PlaceHostBoxes).
  /// @pre Collective, after Check
  HostGrid Place(Ranks& ranks) const;

private:
  struct Block
  {
    std::optional<BoundedCells> Cells;
    std::vector<HostArray> Materials, States;
    const int* MaterialIds = nullptr;

    FieldNames Names() const;
    /// @param first  names of the first block
    void Check(const FieldNames& first) const;
  };

  Block& Last();

  std::vector<Block> Blocks;
};

} // namespace vfm
