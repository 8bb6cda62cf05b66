#include "VtkInput.h"

#include "ArrayMemory.h"
#include "BlockArraysOfData.h"
#include "CollectBlocks.h"
#include "MissingLevels.h"
#include "SurfaceFields.h"

#include "vtkBoundingBox.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkImageData.h"
#include "vtkRectilinearGrid.h"

#include <algorithm>

namespace vfm
{
namespace
{

/// Counts the cells that are not ghost cells.
Index CountCells(vtkDataSet* grid)
{
  const auto marks = MarksOf(FindGhostTypes(grid, vtkDataObject::CELL));
  return marks ? std::count_if(marks->begin(), marks->end(),
                   [](unsigned char mark) { return (mark & CellMark::Ghost) == 0; })
               : grid->GetNumberOfCells();
}

IndexBox FindBox(vtkDataSet* grid)
{
  auto* image = vtkImageData::SafeDownCast(grid);
  auto* rectilinear = vtkRectilinearGrid::SafeDownCast(grid);
  const int* e = image ? image->GetExtent() : rectilinear ? rectilinear->GetExtent() : nullptr;
  return e ? IndexBox{ { { e[0], e[2], e[4] } }, { { e[1], e[3], e[5] } } } : IndexBox();
}

/// Extends the bounds of an image by half a cell, because its points are centres of cells.
void Widen(vtkImageData* image, CellsInfo& info, vtkBoundingBox& bounds)
{
  info.Count = image->GetNumberOfPoints();
  for (Index& end : info.Box.Upper)
  {
    ++end;
  }
  for (int corner = 0; corner < 8; ++corner)
  {
    Vector3 index, point;
    for (int a = 0; a < 3; ++a)
    {
      const Index node = (corner >> a) & 1 ? info.Box.Upper[a] : info.Box.Lower[a];
      index[a] = static_cast<double>(node) - 0.5;
    }
    image->TransformContinuousIndexToPhysicalPoint(index.data(), point.data());
    bounds.AddPoint(point.data());
  }
}

CellsInfo Describe(vtkDataSet* grid, ArrayPlace place)
{
  CellsInfo info;
  info.Box = FindBox(grid);
  vtkBoundingBox bounds(grid->GetBounds());
  if (place == ArrayPlace::Points)
  {
    Widen(vtkImageData::SafeDownCast(grid), info, bounds);
  }
  else
  {
    info.Count = CountCells(grid);
  }
  for (int a = 0; a < 3; ++a)
  {
    info.Lower[a] = bounds.GetMinPoint()[a];
    info.Upper[a] = bounds.GetMaxPoint()[a];
    const auto cells = static_cast<double>(info.Box.Size(a));
    info.Widths[a] = cells > 0.0 ? (info.Upper[a] - info.Lower[a]) / cells : 0.0;
  }
  return info;
}

} // namespace

std::vector<vtkDataSet*> GetGrids(vtkDataObject* data)
{
  std::vector<vtkDataSet*> grids;
  for (const InputPart& part : FindParts(data, 0, true))
  {
    vtkDataSet* grid = vtkDataSet::SafeDownCast(part.Data);
    if (grid && grid->GetNumberOfCells() > 0)
    {
      grids.push_back(grid);
    }
  }
  return grids;
}

Input MakeInput(vtkSmartPointer<vtkDataObject> data, Ranks& ranks)
{
  Input input;
  for (vtkDataSet* grid : GetGrids(data))
  {
    input.Pieces.push_back({ ArraysOf(grid, vtkDataObject::CELL),
      ArraysOf(grid, vtkDataObject::POINT), vtkImageData::SafeDownCast(grid) != nullptr,
      [grid](ArrayPlace place) { return Describe(grid, place); } });
  }
  input.IsOne = !ranks.Any(vtkCompositeDataSet::SafeDownCast(data) != nullptr);
  input.Collect = [data](const ArraysToRead& arrays, Ranks& all)
  { return CollectAllBlocks(data, arrays, all); };
  input.Warning = DescribeMissingLevels(data, ranks);
  input.Surfaces = FindSurfaces(data, ranks);
  return input;
}

} // namespace vfm
