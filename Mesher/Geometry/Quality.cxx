#include "Geometry/Quality.h"

#include "Base/ExactSum.h"
#include "Base/HexNumbering.h"
#include "Base/Vector3.h"
#include "Elements/FlatMesh.h"
#include "Elements/TetQuality.h"
#include "Octree/RefinedGrid.h"

#include <mutex>

namespace vfm
{
namespace
{

double Normalised(const Vector3& a, const Vector3& b, const Vector3& c)
{
  const double lengths = std::sqrt(Dot(a, a) * Dot(b, b) * Dot(c, c));
  return lengths > 0.0 ? Dot(a, Cross(b, c)) / lengths : 0.0;
}

} // namespace

double HexScaledJacobian(const double* points, const Index* hex)
{
  const double scale = LengthScale(points, hex, 8);
  Vector3 x[8];
  for (int c = 0; c < 8; ++c)
  {
    const double* p = points + 3 * hex[VtkCorner[c]];
    x[c] = { { scale * p[0], scale * p[1], scale * p[2] } };
  }
  Vector3 axis[3]{};
  double smallest = 1.0;
  for (int c = 0; c < 8; ++c)
  {
    Vector3 edge[3];
    for (int a = 0; a < 3; ++a)
    {
      const double sign = c >> a & 1 ? -1.0 : 1.0;
      edge[a] = sign * (x[c ^ 1 << a] - x[c]);
      axis[a] = axis[a] - sign * x[c];
    }
    smallest = std::min(smallest, Normalised(edge[0], edge[1], edge[2]));
  }
  return std::min(smallest, Normalised(axis[0], axis[1], axis[2]));
}

double FlatScaledJacobian(const double* points, const Index* element, int corners)
{
  const double scale = LengthScale(points, element, corners);
  Vector3 x[4];
  for (int c = 0; c < corners; ++c)
  {
    const double* p = points + 3 * element[c];
    x[c] = { { scale * p[0], scale * p[1], scale * p[2] } };
  }
  Vector3 normal = corners == 4 ? Cross(x[2] - x[0], x[3] - x[1]) : Cross(x[1] - x[0], x[2] - x[0]);
  const double area = Norm(normal);
  double smallest = 1.0, longest = 0.0;
  for (int c = 0; c < corners; ++c)
  {
    const Vector3 a = x[(c + 1) % corners] - x[c], b = x[(c + corners - 1) % corners] - x[c];
    const double lengths = std::sqrt(Dot(a, a) * Dot(b, b));
    const double jacobian = area > 0.0 ? Dot(Cross(a, b), normal) / area : 0.0;
    smallest = std::min(smallest, lengths > 0.0 ? jacobian / lengths : 0.0);
    longest = std::max(longest, lengths);
  }
  constexpr double OfEquilateral = 1.1547005383792515; // 2 / sqrt(3)
  return corners == 4 ? smallest : longest > 0.0 ? OfEquilateral * area / longest : 0.0;
}

bool AreCellsPerfect(const CartesianGrid& grid)
{
  double largest = 0.0, narrowest = 1e300;
  for (int a = 0; a < 3; ++a)
  {
    const std::vector<double>& x = grid.Coordinates(a);
    largest = std::max({ largest, std::fabs(x.front()), std::fabs(x.back()) });
    for (Index i = 0; i + 1 < static_cast<Index>(x.size()); ++i)
    {
      narrowest = std::min(narrowest, grid.Width(a, i));
    }
  }
  return narrowest >= 0x1p-34 * largest;
}

namespace
{

/// Fills mesh.ScaledJacobian. Returns the number of hexes, from the first one, that have the value
/// 1 because they are unchanged cells.
Index MeasureHexes(Index wholeCells, Runtime& runtime, Mesh& mesh)
{
  float* const values = mesh.ScaledJacobian.data();
  const Index cells = wholeCells > 0 && AreCellsPerfect(mesh.Levels->Finest()) ? wholeCells : 0;
  runtime.For(
    0, cells, [values](Index begin, Index end) { std::fill(values + begin, values + end, 1.0f); });
  ForEach(runtime, static_cast<Index>(mesh.ScaledJacobian.size()) - cells,
    [&](Index e)
    {
      values[cells + e] = static_cast<float>(
        HexScaledJacobian(mesh.Points.data(), mesh.Elements.data() + 8 * (cells + e)));
    });
  return cells;
}

/// Fills mesh.ScaledJacobian of elements of a plane.
void MeasureFlat(Runtime& runtime, Mesh& mesh)
{
  ForEach(runtime, static_cast<Index>(mesh.ScaledJacobian.size()),
    [&](Index e)
    {
      mesh.ScaledJacobian[e] = static_cast<float>(FlatScaledJacobian(
        mesh.Points.data(), mesh.Elements.data() + mesh.Corners * e, mesh.Corners));
    });
}

/// Fills mesh.ScaledJacobian and the dihedral angles of the report.
void MeasureAllTets(Mesh& mesh, Runtime& runtime, MeshReport& report)
{
  AngleStatistics angles;
  std::mutex mutex;
  runtime.For(0, static_cast<Index>(mesh.ScaledJacobian.size()),
    [&](Index first, Index last)
    {
      const AngleStatistics part = MeasureTets(mesh.Points.data(), mesh.Elements.data() + 4 * first,
        last - first, mesh.ScaledJacobian.data() + first);
      const std::lock_guard<std::mutex> lock(mutex);
      angles.Add(part);
    });
  std::vector<std::int64_t> counts(angles.Counts.begin(), angles.Counts.end());
  runtime.Group().Sum(counts);
  std::copy(counts.begin(), counts.end(), report.DihedralAngles.begin());
  report.MaximumDihedralAngle = runtime.Group().Max(angles.Largest);
  report.MinimumDihedralAngle =
    report.MaximumDihedralAngle > 0.0 ? -runtime.Group().Max(-angles.Smallest) : 0.0;
}

} // namespace

void ComputeQuality(
  Mesh& mesh, Runtime& runtime, MeshReport& report, Index wholeCells, Index leftOut)
{
  mesh.ScaledJacobian = Buffer<float>(static_cast<Index>(mesh.ElementIds.size()));
  Index cells = 0;
  if (mesh.HasHexes())
  {
    cells = MeasureHexes(wholeCells, runtime, mesh);
  }
  else if (IsFlat(mesh))
  {
    MeasureFlat(runtime, mesh);
  }
  else
  {
    MeasureAllTets(mesh, runtime, report);
  }
  std::vector<ExactSum> sums(2); // sum and number of the scaled Jacobians
  sums[0].Add(1.0, cells + leftOut);
  double smallest = 1.0;
  for (const float* value = mesh.ScaledJacobian.begin() + cells; value < mesh.ScaledJacobian.end();
       ++value)
  {
    sums[0].Add(*value);
    smallest = std::min(smallest, static_cast<double>(*value));
  }
  sums[1].Add(static_cast<double>(static_cast<Index>(mesh.ScaledJacobian.size()) + leftOut));
  const std::vector<double> total = SumOverRanks(sums, runtime.Group());
  report.MinimumScaledJacobian = -runtime.Group().Max(-smallest);
  report.MeanScaledJacobian = total[1] > 0.0 ? total[0] / total[1] : 0.0;
  if (total[1] == 0.0)
  {
    report.MinimumScaledJacobian = 0.0;
  }
}

} // namespace vfm
