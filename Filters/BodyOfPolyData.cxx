#include "BodyOfPolyData.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkTriangleFilter.h"

namespace vfm
{

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
  return MakeBody(name, std::move(points), std::move(triangles));
}

} // namespace vfm
