#include "Mesh/Quality.h"

#include "Base/ExactSum.h"
#include "Base/HexNumbering.h"
#include "Base/Vector3.h"
#include "Mesh/TetQuality.h"

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
  Vector3 x[8];
  for (int c = 0; c < 8; ++c)
  {
    const double* p = points + 3 * hex[VtkCorner[c]];
    x[c] = { { p[0], p[1], p[2] } };
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

namespace
{

/// Smallest and largest dihedral angle, and how many there are in each ten degrees.
void MeasureAngles(const Mesh& mesh, Ranks& ranks, MeshReport& report)
{
  std::vector<std::int64_t> counts(report.DihedralAngles.size(), 0);
  double smallest = 180.0, largest = 0.0;
  for (std::size_t t = 0; t < mesh.ElementIds.size(); ++t)
  {
    double angles[6];
    DihedralAngles(mesh.Points.data(), mesh.Elements.data() + 4 * t, angles);
    for (double angle : angles)
    {
      smallest = std::min(smallest, angle);
      largest = std::max(largest, angle);
      ++counts[std::min<std::size_t>(static_cast<std::size_t>(angle / 10.0), counts.size() - 1)];
    }
  }
  ranks.Sum(counts);
  std::copy(counts.begin(), counts.end(), report.DihedralAngles.begin());
  report.MaximumDihedralAngle = ranks.Max(largest);
  report.MinimumDihedralAngle = report.MaximumDihedralAngle > 0.0 ? -ranks.Max(-smallest) : 0.0;
}

} // namespace

void ComputeQuality(Mesh& mesh, Runtime& runtime, MeshReport& report)
{
  const Index count = static_cast<Index>(mesh.ElementIds.size());
  mesh.ScaledJacobian = Buffer<float>(count);
  ForEach(runtime, count,
    [&](Index h)
    {
      const Index* element = mesh.Elements.data() + mesh.Corners * h;
      mesh.ScaledJacobian[h] =
        static_cast<float>(mesh.Corners == 8 ? HexScaledJacobian(mesh.Points.data(), element)
                                             : TetScaledJacobian(mesh.Points.data(), element));
    });
  std::vector<ExactSum> sums(2); // of the scaled Jacobians, and their number
  double smallest = 1.0;
  for (float value : mesh.ScaledJacobian)
  {
    sums[0].Add(value);
    smallest = std::min(smallest, static_cast<double>(value));
  }
  sums[1].Add(static_cast<double>(count));
  const std::vector<double> total = SumOverRanks(sums, runtime.Group());
  report.MinimumScaledJacobian = -runtime.Group().Max(-smallest);
  report.MeanScaledJacobian = total[1] > 0.0 ? total[0] / total[1] : 0.0;
  if (total[1] == 0.0)
  {
    report.MinimumScaledJacobian = 0.0;
  }
  if (mesh.Corners == 4)
  {
    MeasureAngles(mesh, runtime.Group(), report);
  }
}

} // namespace vfm
