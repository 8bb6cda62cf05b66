#include "RecogniseGrid.h"

#include "ArrayMemory.h"
#include "BlockArraysOfData.h"
#include "Blocks/HexBoxes.h"
#include "CellOrder.h"
#include "CollectBlocks.h"

#include "vtkCell.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkGenericCell.h"
#include "vtkPointSet.h"
#include "vtkSmartPointer.h"
#include "vtkStructuredGrid.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace vfm
{
namespace
{

/// The cells of a data set of VTK.
class CellsOfData : public HexCells
{
public:
  explicit CellsOfData(vtkPointSet* data) : Data(data) {}

  Index NumberOfPoints() const override { return this->Data->GetNumberOfPoints(); }
  Vector3 GetPoint(Index point) const override
  {
    Vector3 place;
    this->Data->GetPoint(point, place.data());
    return place;
  }
  std::span<const Index> GetCorners(Index cell) override
  {
    this->Data->GetCellPoints(cell, this->Points);
    const vtkIdType* first = this->Points->GetPointer(0);
    this->Corners.assign(first, first + this->Points->GetNumberOfIds());
    return this->Corners;
  }

private:
  vtkPointSet* Data;
  vtkNew<vtkIdList> Points;
  std::vector<Index> Corners;
};

/// Checks that the arrays of an unstructured grid belong together. Readers of VTK accept files
/// whose arrays contradict each other; access to their cells would then end the program.
void CheckConnectivity(vtkPointSet* data, const std::string& name)
{
  vtkUnstructuredGrid* grid = vtkUnstructuredGrid::SafeDownCast(data);
  vtkCellArray* cells = grid ? grid->GetCells() : nullptr;
  vtkUnsignedCharArray* types = grid ? grid->GetCellTypesArray() : nullptr;
  if (!cells || cells->GetNumberOfCells() == 0)
  {
    return;
  }
  if (!cells->IsValid() || !types || types->GetNumberOfValues() != cells->GetNumberOfCells())
  {
    throw InputError(
      name + " is damaged: the types, offsets and points of its cells contradict each other.");
  }
}

/// Returns why a cell that is not a hexahedron cannot be meshed; an empty text for cells of less
/// than three dimensions, which are ignored.
std::string FindTypeProblem(int type)
{
  const auto cell = vtkSmartPointer<vtkCell>::Take(vtkGenericCell::InstantiateCell(type));
  if (!cell)
  {
    return "is of the type " + std::to_string(type) + ", which VTK does not know.";
  }
  if (cell->GetCellDimension() < 3)
  {
    return "";
  }
  return std::string("is a ") + cell->GetClassName() +
    ". Only hexahedra and voxels that are the cells of a Cartesian grid can be meshed: bring other "
    "cells onto a grid first (ParaView's filter Resample To Image).";
}

/// Returns the hexahedra and voxels that are not ghost cells.
std::vector<Index> FindCells(vtkPointSet* data, const std::string& name)
{
  std::vector<Index> cells;
  vtkStructuredGrid* grid = vtkStructuredGrid::SafeDownCast(data);
  const bool isStructured = grid && grid->GetDataDimension() == 3; // blanked cells have no type
  const auto ghosts = InMemory(FindGhostTypes(data, vtkDataObject::CELL));
  int known = VTK_EMPTY_CELL; // type without a problem
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    const int type = isStructured ? VTK_HEXAHEDRON : data->GetCellType(cell);
    const bool isHex = type == VTK_HEXAHEDRON || type == VTK_VOXEL;
    if (!isHex && type != known)
    {
      const std::string problem = FindTypeProblem(type);
      if (!problem.empty())
      {
        RejectCell(name, cell, problem);
      }
      known = type;
    }
    if (isHex && !(ghosts && (ghosts->GetValue(cell) & vtkDataSetAttributes::DUPLICATECELL)))
    {
      cells.push_back(cell);
    }
  }
  return cells;
}

} // namespace

std::vector<InputBlock> RecogniseGrid(vtkPointSet* data, int number, const std::string& name)
{
  CheckConnectivity(data, name);
  CellsOfData corners(data);
  HexBoxes boxes = FindHexBoxes(corners, FindCells(data, name), number, name);
  const auto order = boxes.HaveOrderOf(data->GetNumberOfCells())
    ? nullptr
    : std::make_shared<CellOrder>(boxes.Cells);
  vtkDataArray* ghosts = FindGhostTypes(data, vtkDataObject::CELL);
  const auto marks = MarksOf(ghosts && order ? order->Arrange(ghosts) : ghosts);
  const auto arrays = ArraysOf(data, vtkDataObject::CELL, order);
  for (InputBlock& block : boxes.Blocks)
  {
    block.Arrays = arrays;
    block.Marks = marks;
  }
  return std::move(boxes.Blocks);
}

} // namespace vfm
