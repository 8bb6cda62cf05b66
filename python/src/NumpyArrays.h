/**
 * NumpyArrays: arrays of numpy as the arrays of a block of cells, which are not copied.
 */
#pragma once

#include "Input/PlainArrays.h"

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>

#include <string>
#include <utility>
#include <vector>

namespace vfm
{

using NumpyArray = nanobind::ndarray<nanobind::ro, nanobind::c_contig, nanobind::device::cpu>;

/// What an array is: type, one of ValueType, rows and values per row. Throws InputError on other shapes than (rows,) and
/// (rows, components), and on other types.
struct NumpyView
{
  NumpyView(const std::string& name, const NumpyArray& values);
  int Type, Components;
  Index Rows;
  const void* Values;
};

/// arrays: names and values of shape (cells,) or (cells, components), to outlive what is returned. Throws InputError on other shapes and
/// types.
std::shared_ptr<const BlockArrays> MakeBlockArrays(
  Index cells, const std::vector<std::pair<std::string, NumpyArray>>& arrays);

} // namespace vfm
