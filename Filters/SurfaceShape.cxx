#include "SurfaceShape.h"

#include "Shapes/ShapesTriangles.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkImplicitPolyDataDistance.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTriangleFilter.h"

#include <memory>
#include <mutex>

namespace vfm
{
namespace
{

ClosedSurface ReadSurface(vtkPolyData* surface)
{
  vtkNew<vtkTriangleFilter> split;
  split->SetInputData(surface);
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
  return CloseSurface(std::move(points), std::move(triangles));
}

vtkSmartPointer<vtkPolyData> MakePolyData(const ClosedSurface& surface)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Vector3& point : surface.Points)
  {
    points->InsertNextPoint(point.data());
  }
  vtkNew<vtkCellArray> triangles;
  for (const PointTriangle& triangle : surface.Triangles)
  {
    const vtkIdType corners[3] = { triangle[0], triangle[1], triangle[2] };
    triangles->InsertNextCell(3, corners);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(triangles);
  return data;
}

/// Distance to a surface. vtkImplicitPolyDataDistance is not thread safe, so each concurrent call
/// uses an instance of its own.
class SurfaceDistance
{
public:
  explicit SurfaceDistance(vtkPolyData* surface) : Surface(surface) {}

  double Evaluate(const Vector3& point)
  {
    const Function function = this->Take();
    double x[3] = { point[0], point[1], point[2] };
    const double distance = function->EvaluateFunction(x);
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Idle.push_back(function);
    return distance;
  }

private:
  using Function = vtkSmartPointer<vtkImplicitPolyDataDistance>;

  Function Take()
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    if (this->Idle.empty())
    {
      vtkNew<vtkPolyData> copy;
      copy->DeepCopy(this->Surface);
      this->Idle.push_back(Function::New());
      this->Idle.back()->SetInput(copy);
    }
    const Function function = this->Idle.back();
    this->Idle.pop_back();
    return function;
  }

  vtkSmartPointer<vtkPolyData> Surface;
  std::mutex Mutex;
  std::vector<Function> Idle;
};

} // namespace

Shape MakeSurfaceShape(int material, vtkPolyData* polygons)
{
  const ClosedSurface surface = ReadSurface(polygons);
  const auto distance = std::make_shared<SurfaceDistance>(MakePolyData(surface));
  return MakeSolid(
    material, surface, [distance](const Vector3& point) { return distance->Evaluate(point); });
}

} // namespace vfm
