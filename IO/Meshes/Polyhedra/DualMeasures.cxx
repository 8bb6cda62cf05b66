#include "Meshes/Polyhedra/DualMeasures.h"

namespace vfm
{
namespace
{

constexpr double LargestSkewness = 3.9; ///< checkMesh of OpenFOAM rejects 4
constexpr double LeastCosine = 0.17;    ///< of 80 degrees between the line and the normal
constexpr double RejectedCosine = 0.03; ///< of 88 degrees; checkMesh rejects 90

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
    width = std::max(width, std::fabs(Dot(direction, PointOfDual(dual, point) - measure.Centre)));
  }
  return Norm(offset) / width;
}

} // namespace

Vector3 PointOfDual(const DualMesh& dual, Index point)
{
  const double* x = dual.Points.data() + 3 * point;
  return { { x[0], x[1], x[2] } };
}

FaceQuality QualityOf(const DualMesh& dual, const CellMeasures& cells, Index face)
{
  const FaceMeasure& measure = cells.Faces[face];
  const Vector3 normal = Unit(measure.Area);
  const Index owner = dual.Owners[face], behind = dual.BehindFace(face);
  const Vector3 fromOwner = measure.Centre - cells.Centres[owner];
  const double depth = Dot(normal, fromOwner) / std::cbrt(cells.Volumes[owner]);
  if (behind == NothingBehind)
  {
    const Vector3 line = Dot(normal, fromOwner) * normal;
    return { depth, 1.0, SkewnessOf(dual, face, measure, fromOwner, line, 0.4) };
  }
  const Vector3 line = cells.Centres[behind] - cells.Centres[owner];
  const double depthBehind =
    Dot(normal, cells.Centres[behind] - measure.Centre) / std::cbrt(cells.Volumes[behind]);
  return { std::min(depth, depthBehind), Dot(normal, line) / Norm(line),
    SkewnessOf(dual, face, measure, fromOwner, line, 0.2) };
}

bool IsPoor(const DualMesh& dual, const CellMeasures& cells, Index face)
{
  const FaceQuality quality = QualityOf(dual, cells, face);
  return quality.Depth <= 0.0 || quality.Cosine < LeastCosine || quality.Skewness > LargestSkewness;
}

bool IsRejected(const DualMesh& dual, const CellMeasures& cells, Index face)
{
  const FaceQuality quality = QualityOf(dual, cells, face);
  return quality.Depth <= 0.0 || quality.Cosine < RejectedCosine ||
    quality.Skewness > LargestSkewness;
}

FaceMeasure MeasureFace(const DualMesh& dual, Index face)
{
  const std::span<const Index> points = dual.PointsOf(face);
  Vector3 sum{};
  for (const Index point : points)
  {
    sum = sum + PointOfDual(dual, point);
  }
  const Vector3 middle = (1.0 / static_cast<double>(points.size())) * sum;
  FaceMeasure measure;
  double total = 0.0;
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    const Vector3 first = PointOfDual(dual, points[p]);
    const Vector3 second = PointOfDual(dual, points[(p + 1) % points.size()]);
    const Vector3 area = 0.5 * Cross(second - first, middle - first);
    const double size = Norm(area);
    measure.Area = measure.Area + area;
    measure.Centre = measure.Centre + (size / 3.0) * (first + second + middle);
    total += size;
  }
  measure.Centre = total > 0.0 ? (1.0 / total) * measure.Centre : middle;
  return measure;
}

std::vector<std::vector<CellFace>> FacesOfCells(const DualMesh& dual)
{
  std::vector<std::vector<CellFace>> faces(dual.NumberOfCells());
  ForFaces(dual,
    [&faces](Index face, Index cell, double sign) {
      faces[cell].push_back({ face, sign });
    });
  return faces;
}

void MeasureCell(const std::vector<CellFace>& faces, Index cell, CellMeasures& cells)
{
  Vector3 sum{}, moment{};
  for (const CellFace& face : faces)
  {
    sum = sum + cells.Faces[face.Face].Centre;
  }
  const Vector3 mean = (1.0 / static_cast<double>(faces.size())) * sum;
  double total = 0.0;
  for (const CellFace& face : faces)
  {
    const FaceMeasure& measure = cells.Faces[face.Face];
    const double volume = face.Sign * Dot(measure.Area, measure.Centre - mean) / 3.0;
    total += volume;
    moment = moment + volume * (0.75 * measure.Centre + 0.25 * mean);
  }
  cells.Volumes[cell] = total;
  cells.Centres[cell] = (1.0 / total) * moment;
}

CellMeasures MeasureCells(const DualMesh& dual)
{
  const std::size_t count = dual.Cells.Nodes.size();
  CellMeasures cells{ {}, std::vector<double>(count, 0.0), std::vector<Vector3>(count, Vector3{}) };
  for (Index face = 0; face < dual.NumberOfFaces(); ++face)
  {
    cells.Faces.push_back(MeasureFace(dual, face));
  }
  const std::vector<std::vector<CellFace>> faces = FacesOfCells(dual);
  for (Index cell = 0; cell < dual.NumberOfCells(); ++cell)
  {
    MeasureCell(faces[cell], cell, cells);
  }
  return cells;
}

} // namespace vfm
