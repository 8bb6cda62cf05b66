/**
 * BlockArraysOfData: the cell or point arrays of a VTK data object as BlockArrays.
 */
#pragma once

#include "Input/BlockArrays.h"

#include <memory>

class vtkDataObject;

namespace vfm
{

class CellOrder;

/// Views the arrays of a data object, which must not change.
/// @param association vtkDataObject::CELL or POINT
/// @param order order of the cells in blocks; null: as in the data object
std::shared_ptr<const BlockArrays> ArraysOf(
  vtkDataObject* data, int association, std::shared_ptr<CellOrder> order = nullptr);

} // namespace vfm
