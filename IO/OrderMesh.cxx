#include "OrderMesh.h"

#include "Base/Runtime.h"
#include "GatherMesh.h"
#include "MeshArrays.h"
#include "Ranks/Agreement.h"
#include "ShareHead.h"

#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <limits>
#include <set>
#include <string>

namespace vfm
{
namespace
{

using MeshPointer = vtkSmartPointer<vtkUnstructuredGrid>;

void CheckIds(vtkIdTypeArray* ids)
{
  if (ids->GetNumberOfValues() > 0 && *std::min_element(ids->Begin(), ids->End()) < 1)
  {
    throw InputError(std::string(ids->GetName()) + " must be 1 or more.");
  }
}

void CheckTypes(vtkUnstructuredGrid* mesh, Ranks& ranks)
{
  std::set<int> types;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    types.insert(mesh->GetCellType(cell));
  }
  const std::vector<int> all = Unite(ranks, std::vector<int>(types.begin(), types.end()));
  if (all.size() != 1 || (all[0] != VTK_HEXAHEDRON && all[0] != VTK_TETRA))
  {
    throw InputError("The mesh must be all hexahedra or all tetrahedra.");
  }
}

/// A shallow copy that knows which arrays are the ids.
MeshPointer NameIds(vtkUnstructuredGrid* mesh)
{
  const auto pointIds = FindMeshIds(mesh->GetPointData(), "GlobalPointIds");
  const auto cellIds = FindMeshIds(mesh->GetCellData(), "GlobalCellIds");
  CheckIds(pointIds);
  CheckIds(cellIds);
  auto copy = MeshPointer::New();
  copy->ShallowCopy(mesh);
  copy->GetPointData()->SetGlobalIds(pointIds);
  copy->GetCellData()->SetGlobalIds(cellIds);
  return copy;
}

double FindTime(vtkUnstructuredGrid* mesh, Ranks& ranks)
{
  constexpr double none = -std::numeric_limits<double>::infinity();
  vtkInformation* information = mesh->GetInformation();
  const bool hasTime = information->Has(vtkDataObject::DATA_TIME_STEP());
  const double time = ranks.Max(hasTime ? information->Get(vtkDataObject::DATA_TIME_STEP()) : none);
  return time == none ? 0.0 : time;
}

} // namespace

MeshPointer OrderMesh(vtkUnstructuredGrid* mesh, Ranks& ranks)
{
  const double time = FindTime(mesh, ranks);
  const MeshPointer shared = ShareHead(mesh, ranks);
  CheckTypes(shared, ranks);
  MeshPointer ordered;
  WorkTogether(ranks,
    [&]
    {
      Ranks alone;
      ordered = GatherMesh(NameIds(shared), alone);
      ordered->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
    });
  return ordered;
}

MeshPointer OrderWholeMesh(vtkUnstructuredGrid* mesh, Ranks& ranks)
{
  return GatherMesh(OrderMesh(mesh, ranks), ranks);
}

} // namespace vfm
