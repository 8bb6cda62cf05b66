#include "SurfaceShape.h"

#include "Base/Runtime.h"
#include "Shapes/ShapesTriangles.h"

#include "vtkCellArray.h"
#include "vtkCleanPolyData.h"
#include "vtkFeatureEdges.h"
#include "vtkIdList.h"
#include "vtkImplicitPolyDataDistance.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPolyDataNormals.h"
#include "vtkSmartPointer.h"
#include "vtkTriangleFilter.h"

#include <memory>
#include <mutex>

namespace vfm
{
namespace
{

std::vector<Triangle> GetTriangles(vtkPolyData* surface)
{
  std::vector<Triangle> triangles;
  vtkCellArray* cells = surface->GetPolys();
  vtkNew<vtkIdList> ids;
  for (vtkIdType t = 0; t < cells->GetNumberOfCells(); ++t)
  {
    cells->GetCellAtId(t, ids);
    Triangle triangle;
    for (int i = 0; i < 3; ++i)
    {
      surface->GetPoint(ids->GetId(i), triangle[i].data());
    }
    triangles.push_back(triangle);
  }
  return triangles;
}

/// Triangles with cell normals that point out.
vtkSmartPointer<vtkPolyData> PrepareSurface(vtkPolyData* surface)
{
  vtkNew<vtkPolyData> geometry; // no arrays
  geometry->CopyStructure(surface);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(geometry);
  vtkNew<vtkCleanPolyData> clean;
  clean->SetInputConnection(triangles->GetOutputPort());
  vtkNew<vtkTriangleFilter> solidTriangles; // drops what collapsed
  solidTriangles->SetInputConnection(clean->GetOutputPort());
  solidTriangles->PassLinesOff();
  solidTriangles->PassVertsOff();
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputConnection(solidTriangles->GetOutputPort());
  normals->SplittingOff();
  normals->ConsistencyOn();
  normals->AutoOrientNormalsOff(); // it would turn the walls of cavities
  normals->ComputeCellNormalsOn();
  normals->ComputePointNormalsOff();
  normals->Update();
  if (TriangleSolid(GetTriangles(normals->GetOutput())).MeasureVolume() < 0.0)
  {
    normals->FlipNormalsOn();
    normals->Update();
  }
  return normals->GetOutput();
}

vtkIdType CountEdges(vtkPolyData* surface, bool boundary)
{
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(surface);
  edges->SetBoundaryEdges(boundary);
  edges->SetNonManifoldEdges(!boundary);
  edges->FeatureEdgesOff();
  edges->ManifoldEdgesOff();
  edges->Update();
  return edges->GetOutput()->GetNumberOfCells();
}

void CheckClosed(vtkPolyData* surface)
{
  if (surface->GetNumberOfPolys() == 0)
  {
    throw InputError("The surface has no polygons.");
  }
  if (const vtkIdType open = CountEdges(surface, true))
  {
    throw InputError("The surface is open: " + std::to_string(open) +
      " edges belong to one triangle only. Close its holes first (ParaView's filter Fill Holes).");
  }
  if (const vtkIdType shared = CountEdges(surface, false))
  {
    throw InputError("The surface is not manifold: " + std::to_string(shared) +
      " edges belong to more than two triangles. Separate its parts first.");
  }
}

/// The distance by as many vtkImplicitPolyDataDistance as threads ask at once, as its evaluation is not thread safe.
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

Shape MakeSurfaceShape(int material, vtkPolyData* surface)
{
  const vtkSmartPointer<vtkPolyData> prepared = PrepareSurface(surface);
  CheckClosed(prepared);
  const auto distance = std::make_shared<SurfaceDistance>(prepared);
  const auto solid = std::make_shared<const TriangleSolid>(GetTriangles(prepared));
  return MakeFunctionShape(
    material, [distance](const Vector3& point) { return distance->Evaluate(point); },
    QueriesOf(solid));
}

} // namespace vfm
