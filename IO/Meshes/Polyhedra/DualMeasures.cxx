#include "Meshes/Polyhedra/DualMeasures.h"

namespace vfm
{
namespace
{

constexpr double LargestSkewness = 3.9; ///< checkMesh of OpenFOAM rejects 4
constexpr double LeastCosine = 0.17;    ///< of 80 degrees between the line and the normal

Vector3 PointAt(const DualMesh& dual, Index point)
{
  const double* x = dual.Points.data() + 3 * point;
  return { { x[0], x[1], x[2] } };
}

/// Returns the distance of the centre of a face from the line through its plane, in widths of the
/// face in this direction or in `share` of the length of the line.
double SkewnessOf(const DualMesh& dual, Index face, const FaceMeasure& measure,
  const Vector3& fromCell, const Vector3& line, double share)
{
  const double slope = Dot(measure.Area, fromCell) / Dot(measure.Area, line);
  const Vector3 offset = fromCell - slope * line;
  const Vector3 direction = Unit(offset);
  double width = share * Norm(line);
  for (const Index point : dual.PointsOf(face))
  {
    width = std::max(width, std::fabs(Dot(direction, PointAt(dual, point) - measure.Centre)));
  }
  return Norm(offset) / width;
}

} // namespace

bool IsPoor(const DualMesh& dual, const CellMeasures& cells, Index face)
{
  const FaceMeasure& measure = cells.Faces[face];
  const Vector3 normal = Unit(measure.Area);
  const Index owner = dual.Owners[face], behind = dual.BehindFace(face);
  const Vector3 fromOwner = measure.Centre - cells.Centres[owner];
  if (Dot(normal, fromOwner) <= 0.0)
  {
    return true;
  }
  if (behind == NothingBehind)
  {
    const Vector3 line = Dot(normal, fromOwner) * normal;
    return SkewnessOf(dual, face, measure, fromOwner, line, 0.4) > LargestSkewness;
  }
  const Vector3 line = cells.Centres[behind] - cells.Centres[owner];
  return Dot(normal, cells.Centres[behind] - measure.Centre) <= 0.0 ||
    Dot(normal, line) < LeastCosine * Norm(line) ||
    SkewnessOf(dual, face, measure, fromOwner, line, 0.2) > LargestSkewness;
}

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
      cells.Centres[cell] = cells.Centres[cell] + volume * (0.75 * measure.Centre + 0.25 * mean);
    });
  for (std::size_t cell = 0; cell < count; ++cell)
  {
    cells.Centres[cell] = (1.0 / cells.Volumes[cell]) * cells.Centres[cell];
  }
  return cells;
}

} // namespace vfm
