/**
 * CellOrder: the cell arrays of a data set in the order of blocks of a grid.
 */
#pragma once

#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <map>
#include <vector>

namespace vfm
{

class CellOrder
{
public:
  /// cells: of the data set, each at most once.
  explicit CellOrder(const std::vector<vtkIdType>& cells)
  {
    this->Cells->SetNumberOfIds(static_cast<vtkIdType>(cells.size()));
    std::copy(cells.begin(), cells.end(), this->Cells->GetPointer(0));
  }

  /// The tuples of the cells; made when first asked for, so from one thread. array: of the data set, which must not change.
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
