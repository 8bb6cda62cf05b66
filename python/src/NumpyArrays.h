/**
 * NumpyArrays: numpy arrays as the arrays of a block of cells, without copies.
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

/// A view of an array of shape (rows,) or (rows, components).
struct NumpyView
{
  /// name: name in messages. Throws InputError on other shapes, and on unsupported types.
  NumpyView(const std::string& name, const NumpyArray& values);
  int Type, Components; ///< Type: one of ValueType
  Index Rows;
  const void* Values;
};

/// Views arrays as BlockArrays.
/// @param arrays names and values, shape (cells,) or (cells, components); must outlive the result
/// @throws InputError if NumpyView does
std::shared_ptr<const BlockArrays> MakeBlockArrays(
  Index cells, const std::vector<std::pair<std::string, NumpyArray>>& arrays);

} // namespace vfm
