#include "Quality.h"

#include "ExactSum.h"
#include "HexTopology.h"
#include "Vector3.h"

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

void ComputeQuality(HexMesh& mesh, Runtime& runtime, HexMeshReport& report)
{
  const Index count = static_cast<Index>(mesh.HexIds.size());
  mesh.ScaledJacobian = Buffer<float>(count);
  runtime.For(0, count,
    [&](Index first, Index last)
    {
      for (Index h = first; h < last; ++h)
      {
        mesh.ScaledJacobian[h] =
          static_cast<float>(HexScaledJacobian(mesh.Points.data(), mesh.Hexes.data() + 8 * h));
      }
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
}

} // namespace vfm
