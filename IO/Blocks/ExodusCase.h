/**
 * ExodusCase: reads an Exodus file, or a decomposed one (FILE.N.0 to FILE.N.N-1), as blocks of
 * cells.
 */
#pragma once

#include "Blocks/BlockFile.h"
#include "Blocks/ExodusFile.h"

#include <string>
#include <vector>

namespace vfm
{

/// Files of this rank; consecutive ranks get consecutive files. Names of element variables are
/// sorted, and those of all files.
class ExodusCase : public BlockFile
{
public:
  /// @param path  the file, or any of its parts
  /// @throws InputError  if a file of this rank is damaged or its number of times differs from the
  ///   first file; the message names the file if it is another one than path
  /// @pre Collective
  ExodusCase(const std::string& path, Ranks& ranks);

  bool Has(const std::string& name) const override;
  /// @throws InputError  also if elements are not the cells of a grid
  std::vector<InputBlock> Read(
    std::size_t step, const std::vector<std::string>& names, Ranks& ranks) const override;

  /// Reads the element blocks of this rank.
  /// @param names  arrays to read: element variables, and "object_id", the ids of the blocks
  /// @throws InputError  if a file is damaged
  std::vector<ElementBlock> ReadElements(
    std::size_t step, const std::vector<std::string>& names) const;

private:
  std::string Path;
  std::vector<std::string> Files;
};

/// Finds the grid of the elements of this rank.
/// @throws InputError  if elements are not the cells of a grid, or if no rank has any
/// @pre Collective
std::vector<InputBlock> FindBlocks(const std::vector<ElementBlock>& elements, Ranks& ranks);

} // namespace vfm
