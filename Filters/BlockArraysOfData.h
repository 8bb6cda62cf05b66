/**
 * BlockArraysOfData: the arrays of cells or points of data of VTK as those of a block.
 */
#pragma once

#include "Input/BlockArrays.h"

#include <memory>

class vtkDataObject;

namespace vfm
{

class CellOrder;

/// association: vtkDataObject::CELL or POINT. order: of the cells of a block; null: as they are. The data must not change.
std::shared_ptr<const BlockArrays> ArraysOf(
  vtkDataObject* data, int association, std::shared_ptr<CellOrder> order = nullptr);

} // namespace vfm
