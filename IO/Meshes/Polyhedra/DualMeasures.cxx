#include "Meshes/Polyhedra/DualMeasures.h"

namespace vfm
{
namespace
{

Vector3 PointAt(const DualMesh& dual, Index point)
{
  const double* x = dual.Points.data() + 3 * point;
  return { { x[0], x[1], x[2] } };
}

} // namespace

FaceMeasure MeasureFace(const DualMesh& dual, Index face)
{
  const std::span<const Index> points = dual.PointsOf(face);
  Vector3 sum{};
  for (const Index point : points)
  {
    sum = sum + PointAt(dual, point);
  }
  const Vector3 middle = (1.0 / static_cast<double>(points.size())) * sum;
  FaceMeasure measure;
  double total = 0.0;
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    const Vector3 first = PointAt(dual, points[p]);
    const Vector3 second = PointAt(dual, points[(p + 1) % points.size()]);
    const Vector3 area = 0.5 * Cross(second - first, middle - first);
    const double size = Norm(area);
    measure.Area = measure.Area + area;
    measure.Centre = measure.Centre + (size / 3.0) * (first + second + middle);
    total += size;
  }
  measure.Centre = total > 0.0 ? (1.0 / total) * measure.Centre : middle;
  return measure;
}

CellMeasures MeasureCells(const DualMesh& dual)
{
  const std::size_t count = dual.Cells.Nodes.size();
  CellMeasures cells{ {}, std::vector<double>(count, 0.0), std::vector<Vector3>(count, Vector3{}) };
  for (Index face = 0; face < dual.NumberOfFaces(); ++face)
  {
    cells.Faces.push_back(MeasureFace(dual, face));
  }
  std::vector<Vector3> means(count, Vector3{});
  std::vector<double> faces(count, 0.0);
  ForFaces(dual,
    [&](Index face, Index cell, double)
    {
      means[cell] = means[cell] + cells.Faces[face].Centre;
      faces[cell] += 1.0;
    });
  ForFaces(dual,
    [&](Index face, Index cell, double sign)
    {
      const FaceMeasure& measure = cells.Faces[face];
      const Vector3 mean = (1.0 / faces[cell]) * means[cell];
      const double volume = sign * Dot(measure.Area, measure.Centre - mean) / 3.0;
      cells.Volumes[cell] += volume;
      cells.Centres[cell] =
        cells.Centres[cell] + volume * (0.75 * measure.Centre + 0.25 * mean);
    });
  for (std::size_t cell = 0; cell < count; ++cell)
  {
    cells.Centres[cell] = (1.0 / cells.Volumes[cell]) * cells.Centres[cell];
  }
  return cells;
}

} // namespace vfm
