#include "FragmentParts.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIntArray.h"
#include "vtkUnstructuredGrid.h"

#include <numeric>

namespace vfm
{

FragmentParts::FragmentParts(vtkUnstructuredGrid* mesh) :
  Mesh(mesh), Order(mesh->GetNumberOfCells())
{
  const int* fragments =
    vtkIntArray::SafeDownCast(mesh->GetCellData()->GetArray("FragmentId"))->GetPointer(0);
  const std::size_t count = this->Order.size();
  const int largest = count ? *std::max_element(fragments, fragments + count) : 0;
  this->First.assign(largest + 2, 0);
  for (std::size_t e = 0; e < count; ++e)
  {
    ++this->First[fragments[e] + 1];
  }
  std::partial_sum(this->First.begin(), this->First.end(), this->First.begin());
  std::vector<Index> next = this->First;
  for (std::size_t e = 0; e < count; ++e)
  {
    this->Order[next[fragments[e]]++] = static_cast<Index>(e);
  }
}

FragmentParts::Part FragmentParts::Get(int fragment) const
{
  Part part;
  if (fragment + 1 >= static_cast<int>(this->First.size()))
  {
    return part;
  }
  part.Elements.assign(
    this->Order.begin() + this->First[fragment], this->Order.begin() + this->First[fragment + 1]);
  for (Index element : part.Elements)
  {
    vtkIdType corners = 0;
    const vtkIdType* points = nullptr;
    this->Mesh->GetCells()->GetCellAtId(element, corners, points);
    part.Points.insert(part.Points.end(), points, points + corners);
  }
  std::sort(part.Points.begin(), part.Points.end());
  part.Points.erase(std::unique(part.Points.begin(), part.Points.end()), part.Points.end());
  return part;
}

} // namespace vfm
