#include "MaterialIds.h"

#include "Base/Runtime.h"
#include "MeshArrays.h"
#include "Ranks/Agreement.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <limits>
#include <set>
#include <string>

namespace vfm
{

std::vector<int> FindMaterials(vtkUnstructuredGrid* mesh, Ranks& ranks)
{
  std::set<int> mine;
  WorkTogether(ranks,
    [&]
    {
      const vtkIdType count = mesh->GetNumberOfCells();
      vtkDataArray* ids = count > 0 ? FindMeshArray(mesh->GetCellData(), "MaterialId") : nullptr;
      int last = -1; // neighbours in the list are mostly of one material
      for (vtkIdType cell = 0; cell < count; ++cell)
      {
        const int id = static_cast<int>(ids->GetComponent(cell, 0));
        if (id != last)
        {
          mine.insert(id);
          last = id;
        }
      }
      if (!mine.empty() && *mine.begin() < 0)
      {
        throw InputError("MaterialId " + std::to_string(*mine.begin()) + " is negative.");
      }
    });
  return Unite(ranks, std::vector<int>(mine.begin(), mine.end()));
}

int FindVoidId(vtkUnstructuredGrid* mesh, Ranks& ranks)
{
  const std::vector<int> materials = FindMaterials(mesh, ranks);
  double largest = materials.empty() ? 0.0 : materials.back();
  if (vtkDataArray* ids = mesh->GetFieldData()->GetArray("MaterialIds"))
  {
    for (vtkIdType i = 0; i < ids->GetNumberOfTuples(); ++i)
    {
      largest = std::max(largest, ids->GetComponent(i, 0));
    }
  }
  largest = ranks.Max(largest);
  if (largest >= std::numeric_limits<int>::max())
  {
    throw InputError("No number is left for the void: a material has the greatest there is, " +
      std::to_string(std::numeric_limits<int>::max()) + ".");
  }
  return static_cast<int>(largest) + 1;
}

} // namespace vfm
