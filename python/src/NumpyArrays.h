/**
 * NumpyArrays: the arrays of a block of cells in memory of numpy, which is not copied.
 */
#pragma once

#include "Input/BlockArrays.h"

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>

#include <string>
#include <utility>
#include <vector>

namespace vfm
{

using NumpyArray = nanobind::ndarray<nanobind::ro, nanobind::c_contig, nanobind::device::cpu>;

class NumpyArrays : public BlockArrays
{
public:
  /// arrays: names and values of shape (cells,) or (cells, components), to outlive this. Throws InputError on other shapes and types.
  NumpyArrays(Index cells, const std::vector<std::pair<std::string, NumpyArray>>& arrays);

  Index NumberOfTuples() const override { return this->Cells; }
  std::shared_ptr<const BlockArray> Find(const std::string& name) const override;
  bool HoldsIds(const std::string&) const override { return false; } // numpy knows none
  std::vector<std::string> Names() const override;

private:
  const Index Cells;
  std::vector<std::pair<std::string, std::shared_ptr<const BlockArray>>> Arrays;
};

} // namespace vfm
