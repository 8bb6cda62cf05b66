/**
 * HostBlocks: the blocks that a host hands over on one rank by the C interface, each with its fields, and what those of all ranks
 * must have alike.
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

/// The fields of a block without their values: alike in all blocks of all ranks.
struct FieldNames
{
  std::vector<FieldName> Materials, States;
  bool HasMaterialIds = false; ///< instead of Materials, in the array MaterialIdName
};

constexpr const char* MaterialIdName = "MaterialIds";

class HostBlocks
{
public:
  ///@{ Pointers to 6 and 3 values, which are copied. What is wrong with them is told by Check.
  /// The first block, of level 0, which keeps the fields that it has; no others.
  void SetOnly(const double* bounds, const int* intervals);
  void Begin(int level, const double* bounds, const int* intervals);
  ///@}
  void Clear() { this->Blocks.clear(); }

  ///@{ Of the block last begun; before any, of the one that SetOnly will set. Values of its cells, which are not copied.
  void AddMaterial(const std::string& name, const double* fractions);
  void AddState(const std::string& name, int components, const double* values);
  void SetMaterialIds(const int* ids);
  ///@}
  /// Of all blocks.
  void ClearFields();

  /// Whether this rank has one block of level 0, as face neighbours need it.
  bool IsOneBox() const { return this->Blocks.size() == 1 && this->Blocks[0].Cells->Level == 0; }
  std::size_t Count() const { return this->Blocks.size(); }

  /// Throws InputError on blocks without cells or fields, with wrong numbers (CheckBoundedCells), with other fields than the first of this
  /// rank. Not collective.
  void Check() const;
  /// Collective, after Check: the names of all blocks, known on ranks without blocks, too. Throws InputError on ranks with others than the
  /// first rank that has blocks, and on all when none has.
  FieldNames AgreeOnNames(Ranks& ranks) const;
  /// Collective, after Check: the blocks with their fields on the grid of all ranks (PlaceHostBoxes).
  HostGrid Place(Ranks& ranks) const;

private:
  struct Block
  {
    std::optional<BoundedCells> Cells;
    std::vector<HostArray> Materials, States;
    const int* MaterialIds = nullptr;

    FieldNames Names() const;
    /// first: of the first block.
    void Check(const FieldNames& first) const;
  };

  Block& Last();

  std::vector<Block> Blocks;
};

} // namespace vfm
