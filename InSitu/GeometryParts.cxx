#include "GeometryParts.h"

#include "ArrayMemory.h"
#include "Base/Sorted.h"
#include "Ranks/Errors.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolumeFractionMeshAlgorithm.h"

namespace vfm
{
namespace
{

vtkCellArray* CellsOf(vtkPolyData* data, int dimension)
{
  return dimension == 2 ? data->GetPolys() : dimension == 1 ? data->GetLines() : data->GetVerts();
}

vtkIdTypeArray* IdsOf(vtkDataSet* data)
{
  return vtkIdTypeArray::SafeDownCast(data->GetPointData()->GetGlobalIds());
}

/// The corners of all cells as points of the mesh, whose ids ascend.
std::vector<Index> FindPoints(vtkPolyData* data, vtkCellArray* cells, vtkUnstructuredGrid* mesh)
{
  const vtkIdTypeArray* ids = IdsOf(data);
  vtkIdTypeArray* all = IdsOf(mesh);
  const vtkIdType* begin = all->GetPointer(0);
  std::vector<Index> place(ids->GetNumberOfValues());
  for (std::size_t p = 0; p < place.size(); ++p)
  {
    place[p] = std::lower_bound(begin, begin + all->GetNumberOfValues(), ids->GetValue(p)) - begin;
  }
  const auto* corners = static_cast<const Index*>(FindMemory(cells->GetConnectivityArray()));
  std::vector<Index> points(cells->GetNumberOfConnectivityIds());
  std::transform(corners, corners + points.size(), points.begin(),
    [&place](Index corner) { return place[corner]; });
  return points;
}

} // namespace

GeometryParts::GeometryParts(vtkVolumeFractionMeshAlgorithm& mesher)
{
  for (int dimension = 0; dimension < 3; ++dimension)
  {
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->ShallowCopy(mesher.GetOutputDataObject(3 - dimension));
    data->SetPoints(nullptr); // the mesh has them
    this->Parts[dimension].Data = data;
  }
}

GeometryParts::Cells GeometryParts::Get(int dimension, vtkUnstructuredGrid* mesh)
{
  Part& part = this->Parts[dimension];
  vtkCellArray* cells = CellsOf(part.Data, dimension);
  const Index count = cells->GetNumberOfCells();
  if (count == 0)
  {
    return { 0, 0, nullptr, nullptr };
  }
  if (part.Points.empty())
  {
    part.Points = FindPoints(part.Data, cells, mesh);
  }
  auto ids = vtkIntArray::SafeDownCast(part.Data->GetCellData()->GetScalars());
  return { count, static_cast<int>(cells->GetMaxCellSize()), part.Points.data(),
    ids->GetPointer(0) };
}

vtkIntArray* GeometryParts::GetTable(const std::string& name) const
{
  for (const Part& part : this->Parts)
  {
    vtkFieldData* tables = part.Data->GetFieldData();
    if (auto table = vtkIntArray::SafeDownCast(tables->GetArray(name.c_str())))
    {
      return table;
    }
  }
  throw InputError("There is no table '" + name + "' of what bounds what.");
}

} // namespace vfm
