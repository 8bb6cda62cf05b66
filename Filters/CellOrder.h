/**
 * CellOrder: arranges the cell arrays of a data set in the order of the blocks of a grid.
 */
#pragma once

#include "Base/IndexBox.h"

#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <map>
#include <vector>

namespace vfm
{

/// Not thread safe.
class CellOrder
{
public:
  /// cells: ids of cells of the data set in the new order, each at most once.
  explicit CellOrder(const std::vector<Index>& cells)
  {
    this->Cells->SetNumberOfIds(static_cast<vtkIdType>(cells.size()));
    std::copy(cells.begin(), cells.end(), this->Cells->GetPointer(0));
  }

  /// Returns the tuples of the cells. The result is stored; the array must not change.
  vtkDataArray* Arrange(vtkDataArray* array)
  {
    vtkSmartPointer<vtkDataArray>& arranged = this->Arranged[array];
    if (!arranged)
    {
      arranged.TakeReference(array->NewInstance());
      arranged->SetNumberOfComponents(array->GetNumberOfComponents());
      arranged->CopyComponentNames(array);
      arranged->SetNumberOfTuples(this->Cells->GetNumberOfIds());
      array->GetTuples(this->Cells, arranged);
    }
    return arranged;
  }

private:
  vtkNew<vtkIdList> Cells;
  std::map<vtkDataArray*, vtkSmartPointer<vtkDataArray>> Arranged;
};

} // namespace vfm
