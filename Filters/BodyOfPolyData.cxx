#include "BodyOfPolyData.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTriangleFilter.h"

#include <map>
#include <utility>

namespace vfm
{
namespace
{

/// Patches of the triangles; none for one patch.
struct PatchLabels
{
  std::vector<int> Patches;
  std::vector<std::string> Names{ "" };
};

vtkDataArray* FindLabels(vtkPolyData* triangles)
{
  for (const char* name : { "STLSolidLabeling", "MaterialIds", "GroupIds" })
  {
    vtkDataArray* labels = triangles->GetCellData()->GetArray(name);
    if (labels && labels->GetNumberOfComponents() == 1)
    {
      return labels;
    }
  }
  return nullptr;
}

/// Returns the name of a label; empty if it has none.
std::string NameLabel(double label, vtkDataArray* labels, vtkPolyData* triangles)
{
  auto* names =
    vtkStringArray::SafeDownCast(triangles->GetFieldData()->GetAbstractArray("MaterialNames"));
  const bool isNamed = names && std::string(labels->GetName()) == "MaterialIds" && label >= 0.0 &&
    label < static_cast<double>(names->GetNumberOfValues());
  return isNamed ? names->GetValue(static_cast<vtkIdType>(label)) : vtkStdString();
}

PatchLabels FindPatches(vtkPolyData* triangles)
{
  PatchLabels found;
  vtkDataArray* labels = FindLabels(triangles);
  if (!labels)
  {
    return found;
  }
  std::map<double, int> numbers;
  for (vtkIdType t = 0; t < labels->GetNumberOfTuples(); ++t)
  {
    numbers.emplace(labels->GetTuple1(t), 0);
  }
  found.Names.clear();
  for (auto& [label, number] : numbers)
  {
    number = static_cast<int>(found.Names.size());
    found.Names.push_back(NameLabel(label, labels, triangles));
  }
  for (vtkIdType t = 0; t < labels->GetNumberOfTuples(); ++t)
  {
    found.Patches.push_back(numbers[labels->GetTuple1(t)]);
  }
  return found;
}

} // namespace

BodySurface MakeBodyOfPolyData(const std::string& name, vtkPolyData* polygons)
{
  vtkNew<vtkTriangleFilter> split;
  split->SetInputData(polygons);
  split->PassLinesOff();
  split->PassVertsOff();
  split->Update();
  vtkPolyData* triangulated = split->GetOutput();
  std::vector<Vector3> points(triangulated->GetNumberOfPoints());
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    triangulated->GetPoint(static_cast<vtkIdType>(p), points[p].data());
  }
  std::vector<PointTriangle> triangles;
  vtkNew<vtkIdList> ids;
  vtkCellArray* cells = triangulated->GetPolys();
  for (vtkIdType t = 0; t < cells->GetNumberOfCells(); ++t)
  {
    cells->GetCellAtId(t, ids);
    triangles.push_back({ { ids->GetId(0), ids->GetId(1), ids->GetId(2) } });
  }
  PatchLabels labels = FindPatches(triangulated);
  return MakeBody(name, std::move(points), std::move(triangles), std::move(labels.Patches),
    std::move(labels.Names));
}

} // namespace vfm
