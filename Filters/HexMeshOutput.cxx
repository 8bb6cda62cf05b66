#include "HexMeshOutput.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkUnstructuredGrid.h"

namespace vfm
{
namespace
{

static_assert(sizeof(vtkIdType) == sizeof(Index), "VTK must be built with 64-bit ids");

/// A VTK array that owns the memory of the buffer from now on.
template <class Array, class T>
vtkSmartPointer<Array> Adopt(Buffer<T>& buffer, const char* name, int components = 1)
{
  using Value = typename Array::ValueType;
  static_assert(sizeof(Value) == sizeof(T), "the buffer must hold the array's type");
  auto array = vtkSmartPointer<Array>::New();
  const vtkIdType size = static_cast<vtkIdType>(buffer.size());
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetArray(
    reinterpret_cast<Value*>(buffer.release()), size, 0, vtkAbstractArray::VTK_DATA_ARRAY_FREE);
  return array;
}

vtkSmartPointer<vtkCellArray> AdoptCells(Buffer<Index>& buffer, int cellSize)
{
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(cellSize, Adopt<vtkTypeInt64Array>(buffer, "Connectivity"));
  return cells;
}

/// From material numbers to the labels of the user.
void SetLabels(Buffer<int>& materials, const Materials& table)
{
  for (int& material : materials)
  {
    material = table.Labels[material];
  }
}

/// The points that the quads use, in the order of the mesh; the quads are renumbered.
void SetSurfacePoints(Buffer<Index>& quads, const Buffer<double>& points, const Buffer<Index>& ids,
  vtkPolyData* surfaces)
{
  std::vector<Index> place(ids.size(), 0);
  for (Index point : quads)
  {
    place[point] = 1;
  }
  Index count = 0;
  for (Index& p : place)
  {
    p = p ? count++ : -1;
  }
  Buffer<double> usedPoints(3 * count);
  Buffer<Index> usedIds(count);
  for (std::size_t p = 0; p < place.size(); ++p)
  {
    if (place[p] >= 0)
    {
      std::copy_n(points.data() + 3 * p, 3, usedPoints.data() + 3 * place[p]);
      usedIds[place[p]] = ids[p];
    }
  }
  for (Index& point : quads)
  {
    point = place[point];
  }
  vtkNew<vtkPoints> vtkpoints;
  vtkpoints->SetData(Adopt<vtkDoubleArray>(usedPoints, "Points", 3));
  surfaces->SetPoints(vtkpoints);
  surfaces->GetPointData()->SetGlobalIds(Adopt<vtkIdTypeArray>(usedIds, "GlobalPointIds"));
}

template <class Array, class T>
void AddFieldValues(vtkFieldData* field, const char* name, const std::vector<T>& values)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    array->SetValue(static_cast<vtkIdType>(i), values[i]);
  }
  field->AddArray(array);
}

void AddFieldCount(vtkFieldData* field, const char* name, Index count)
{
  AddFieldValues<vtkIdTypeArray>(field, name, std::vector<Index>{ count });
}

} // namespace

void SetHexMeshOutput(
  HexMesh& hexes, const Materials& table, vtkUnstructuredGrid* mesh, vtkPolyData* surfaces)
{
  SetSurfacePoints(hexes.Surfaces.Points, hexes.Points, hexes.PointIds, surfaces);
  surfaces->SetPolys(AdoptCells(hexes.Surfaces.Points, 4));
  SetLabels(hexes.Surfaces.MaterialPair, table);
  vtkCellData* sides = surfaces->GetCellData();
  sides->SetScalars(Adopt<vtkIntArray>(hexes.Surfaces.SurfaceId, "SurfaceId"));
  sides->AddArray(Adopt<vtkIntArray>(hexes.Surfaces.MaterialPair, "MaterialPair", 2));
  sides->AddArray(Adopt<vtkIntArray>(hexes.Surfaces.DomainSide, "DomainSide"));

  vtkNew<vtkPoints> points;
  points->SetData(Adopt<vtkDoubleArray>(hexes.Points, "Points", 3));
  mesh->SetPoints(points);
  mesh->SetCells(VTK_HEXAHEDRON, AdoptCells(hexes.Hexes, 8));
  SetLabels(hexes.Material, table);
  vtkCellData* cells = mesh->GetCellData();
  cells->SetScalars(Adopt<vtkIntArray>(hexes.Material, "MaterialId"));
  cells->AddArray(Adopt<vtkIntArray>(hexes.Fragment, "FragmentId"));
  cells->SetGlobalIds(Adopt<vtkIdTypeArray>(hexes.HexIds, "GlobalCellIds"));
  if (!hexes.ScaledJacobian.empty())
  {
    cells->AddArray(Adopt<vtkFloatArray>(hexes.ScaledJacobian, "ScaledJacobian"));
  }
  vtkPointData* nodes = mesh->GetPointData();
  nodes->SetGlobalIds(Adopt<vtkIdTypeArray>(hexes.PointIds, "GlobalPointIds"));
  nodes->AddArray(Adopt<vtkIntArray>(hexes.GeometryDimension, "GeometryDimension"));
  nodes->AddArray(Adopt<vtkIntArray>(hexes.GeometryId, "GeometryId"));
}

void SetReportOutput(const HexMeshReport& report, const Materials& table,
  const HexMeshOptions& options, Index normalisedCells, vtkDataObject* output)
{
  const std::size_t first = options.MeshVoid ? 0 : 1;
  vtkFieldData* field = output->GetFieldData();
  vtkNew<vtkStringArray> names;
  names->SetName("MaterialNames");
  for (std::size_t m = first; m < table.Names.size(); ++m)
  {
    names->InsertNextValue(table.Names[m]);
  }
  field->AddArray(names);
  auto meshed = [first](const auto& values)
  {
    using Value = std::decay_t<decltype(values[0])>;
    return std::vector<Value>(values.begin() + std::min(first, values.size()), values.end());
  };
  AddFieldValues<vtkIntArray>(field, "MaterialIds", meshed(table.Labels));
  AddFieldValues<vtkDoubleArray>(field, "TargetVolume", meshed(report.TargetVolume));
  AddFieldValues<vtkDoubleArray>(field, "MeshVolume", meshed(report.MeshVolume));
  AddFieldCount(field, "NormalisedCells", normalisedCells);
  AddFieldCount(field, "FlippedCells", report.FlippedCells);
  AddFieldCount(field, "ResolveRounds", report.ResolveRounds);
  AddFieldCount(field, "NumberOfFragments", report.NumberOfFragments);
  AddFieldCount(field, "NumberOfSurfaces", report.NumberOfSurfaces);
  AddFieldCount(field, "NumberOfCurves", report.NumberOfCurves);
  AddFieldCount(field, "NumberOfVertices", report.NumberOfVertices);
  if (options.ComputeQuality)
  {
    AddFieldValues<vtkDoubleArray>(
      field, "MinimumScaledJacobian", std::vector<double>{ report.MinimumScaledJacobian });
    AddFieldValues<vtkDoubleArray>(
      field, "MeanScaledJacobian", std::vector<double>{ report.MeanScaledJacobian });
  }
}

} // namespace vfm
