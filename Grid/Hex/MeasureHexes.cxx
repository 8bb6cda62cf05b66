#include "Hex/MeasureHexes.h"

#include "Base/ExactSum.h"
#include "Base/HexVolume.h"

namespace vfm
{
namespace
{

/// In mean cells. From the first corner, so that coordinates may be large.
double VolumeOfHex(const Mesh& mesh, const Index* hex, double scale)
{
  std::array<Vector3, 8> x;
  for (int c = 0; c < 8; ++c)
  {
    std::copy_n(mesh.Points.data() + 3 * hex[c], 3, x[c].begin());
  }
  std::array<Vector3, 4> lower, upper;
  for (int c = 0; c < 4; ++c)
  {
    lower[c] = scale * (x[c] - x[0]);
    upper[c] = scale * (x[c + 4] - x[0]);
  }
  return VolumeBetween(lower, upper);
}

} // namespace

std::vector<double> MeasureHexes(
  const Mesh& mesh, const CartesianGrid& grid, int fragments, Runtime& runtime)
{
  const Index count = static_cast<Index>(mesh.ElementIds.size());
  const double scale = 1.0 / grid.MeanWidth();
  std::vector<double> volumes(count, 0.0);
  runtime.For(0, count,
    [&](Index begin, Index end)
    {
      for (Index h = begin; h < end; ++h)
      {
        if (grid.Owned().Contains(CellOfElement(grid, mesh, mesh.ElementIds[h])))
        {
          volumes[h] = VolumeOfHex(mesh, mesh.Elements.data() + 8 * h, scale);
        }
      }
    });
  std::vector<ExactSum> sums(fragments + 1);
  for (Index h = 0; h < count; ++h)
  {
    sums[mesh.Fragment[h]].Add(volumes[h]);
  }
  return SumOverRanks(sums, runtime.Group());
}

} // namespace vfm
