#include "SurfaceShape.h"

#include "Runtime.h"
#include "Vector3.h"

#include "vtkCellArray.h"
#include "vtkCleanPolyData.h"
#include "vtkFeatureEdges.h"
#include "vtkIdList.h"
#include "vtkImplicitPolyDataDistance.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPolyDataNormals.h"
#include "vtkSMPThreadLocal.h"
#include "vtkSmartPointer.h"
#include "vtkStaticCellLocator.h"
#include "vtkTriangleFilter.h"

#include <memory>

namespace vfm
{
namespace
{

/// Six times the volume inside, negative when the triangles face inwards.
double MeasureInside(vtkPolyData* triangles)
{
  Vector3 center;
  triangles->GetCenter(center.data());
  double sum = 0.0;
  vtkCellArray* cells = triangles->GetPolys();
  vtkNew<vtkIdList> ids;
  for (vtkIdType t = 0; t < cells->GetNumberOfCells(); ++t)
  {
    cells->GetCellAtId(t, ids);
    Vector3 p[3];
    for (int i = 0; i < 3; ++i)
    {
      triangles->GetPoint(ids->GetId(i), p[i].data());
      p[i] = p[i] - center;
    }
    sum += Dot(p[0], Cross(p[1], p[2]));
  }
  return sum;
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
  if (MeasureInside(normals->GetOutput()) < 0.0)
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
      " edges belong to one triangle only. Close its holes first (filter Fill Holes).");
  }
  if (const vtkIdType shared = CountEdges(surface, false))
  {
    throw InputError("The surface is not manifold: " + std::to_string(shared) +
      " edges belong to more than two triangles. Separate its parts first.");
  }
}

/// A convex polygon; a triangle clipped by the six planes of a box has at most nine corners.
struct Polygon
{
  int Size = 0;
  Vector3 Corners[9];
};

/// The part where sign * (x[axis] - value) <= 0.
Polygon ClipPolygon(const Polygon& polygon, int axis, double value, double sign)
{
  Polygon part;
  for (int i = 0; i < polygon.Size; ++i)
  {
    const Vector3& a = polygon.Corners[i];
    const Vector3& b = polygon.Corners[i + 1 < polygon.Size ? i + 1 : 0];
    const double heightA = sign * (a[axis] - value), heightB = sign * (b[axis] - value);
    if (heightA <= 0.0)
    {
      part.Corners[part.Size++] = a;
    }
    if ((heightA <= 0.0) != (heightB <= 0.0))
    {
      part.Corners[part.Size++] = a + heightA / (heightA - heightB) * (b - a);
    }
  }
  return part;
}

/// Integral of x - start over the polygon's shadow on the yz plane; negative where it faces -x.
/// width: taken for x - start when not negative.
double IntegrateShadow(const Polygon& polygon, double start, double width)
{
  double sum = 0.0;
  for (int i = 1; i + 1 < polygon.Size; ++i)
  {
    const Vector3 &a = polygon.Corners[0], &b = polygon.Corners[i], &c = polygon.Corners[i + 1];
    const double area = 0.5 * Cross(b - a, c - a)[0];
    sum += area * (width >= 0.0 ? width : (a[0] + b[0] + c[0]) / 3.0 - start);
  }
  return sum;
}

/// Volume of the points of the box from which the ray to +x hits the triangle, negative where it faces
/// -x. Summed over a closed surface: the volume inside, as a point is inside when its ray leaves the
/// solid once more than it enters.
double MeasureShadowVolume(const Polygon& triangle, const Vector3& lower, const Vector3& upper)
{
  Polygon part = triangle;
  for (int axis = 1; axis < 3; ++axis)
  {
    part = ClipPolygon(ClipPolygon(part, axis, lower[axis], -1.0), axis, upper[axis], 1.0);
  }
  const Polygon within = ClipPolygon(ClipPolygon(part, 0, lower[0], -1.0), 0, upper[0], 1.0);
  const Polygon beyond = ClipPolygon(part, 0, upper[0], -1.0);
  return IntegrateShadow(within, lower[0], -1.0) +
    IntegrateShadow(beyond, 0.0, upper[0] - lower[0]);
}

/// Evaluates one surface; one a thread, as the VTK classes inside are not thread safe.
class SurfaceProbe
{
public:
  explicit SurfaceProbe(vtkPolyData* surface)
  {
    this->Triangles->DeepCopy(surface);
    this->Distance->SetInput(this->Triangles);
    this->Locator->SetDataSet(this->Triangles);
    this->Locator->BuildLocator();
  }

  double EvaluateDistance(const Vector3& point)
  {
    double x[3] = { point[0], point[1], point[2] };
    return this->Distance->EvaluateFunction(x);
  }

  double MeasureVolume(const Vector3& lower, const Vector3& upper)
  {
    const double* bounds = this->Triangles->GetBounds();
    double column[6] = { lower[0], std::max(upper[0], bounds[1]), lower[1], upper[1], lower[2],
      upper[2] };
    this->Locator->FindCellsWithinBounds(column, this->Cells);
    double sum = 0.0;
    for (vtkIdType c = 0; c < this->Cells->GetNumberOfIds(); ++c)
    {
      this->Triangles->GetCellPoints(this->Cells->GetId(c), this->Points);
      Polygon triangle;
      for (triangle.Size = 0; triangle.Size < 3; ++triangle.Size)
      {
        this->Triangles->GetPoint(
          this->Points->GetId(triangle.Size), triangle.Corners[triangle.Size].data());
      }
      sum += MeasureShadowVolume(triangle, lower, upper);
    }
    return sum;
  }

private:
  vtkNew<vtkPolyData> Triangles;
  vtkNew<vtkImplicitPolyDataDistance> Distance;
  vtkNew<vtkStaticCellLocator> Locator;
  vtkNew<vtkIdList> Cells, Points;
};

class SurfaceProbes
{
public:
  explicit SurfaceProbes(vtkPolyData* surface) : Surface(surface) {}

  SurfaceProbe& Local()
  {
    std::shared_ptr<SurfaceProbe>& probe = this->Probes.Local();
    if (!probe)
    {
      probe = std::make_shared<SurfaceProbe>(this->Surface);
    }
    return *probe;
  }

private:
  vtkSmartPointer<vtkPolyData> Surface;
  vtkSMPThreadLocal<std::shared_ptr<SurfaceProbe>> Probes;
};

} // namespace

Shape MakeSurfaceShape(int material, vtkPolyData* surface)
{
  const vtkSmartPointer<vtkPolyData> prepared = PrepareSurface(surface);
  CheckClosed(prepared);
  const auto probes = std::make_shared<SurfaceProbes>(prepared);
  return MakeFunctionShape(
    material, [probes](const Vector3& point) { return probes->Local().EvaluateDistance(point); },
    [probes](const Vector3& lower, const Vector3& upper)
    { return probes->Local().MeasureVolume(lower, upper); });
}

} // namespace vfm
