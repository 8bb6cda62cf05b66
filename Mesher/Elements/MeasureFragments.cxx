#include "Elements/MeasureFragments.h"

#include "Base/ExactSum.h"
#include "Base/HexVolume.h"

namespace vfm
{

// Coordinates are relative to the first corner, which limits rounding errors if they are large.
double VolumeOfElement(const Mesh& mesh, Index element, double unit)
{
  std::array<Vector3, 8> x;
  for (int c = 0; c < mesh.Corners; ++c)
  {
    x[c] = mesh.PointAt(mesh.Elements[mesh.Corners * element + c]);
  }
  if (mesh.Corners == 4)
  {
    return Dot(x[1] - x[0], Cross(x[2] - x[0], x[3] - x[0])) / (6.0 * unit * unit * unit);
  }
  const double scale = 1.0 / unit;
  std::array<Vector3, 4> lower, upper;
  for (int c = 0; c < 4; ++c)
  {
    lower[c] = scale * (x[c] - x[0]);
    upper[c] = scale * (x[c + 4] - x[0]);
  }
  return VolumeBetween(lower, upper);
}

std::vector<double> MeasureFragments(
  const Mesh& mesh, const CartesianGrid& grid, int fragments, Runtime& runtime)
{
  const double width = grid.MeanWidth();
  std::vector<double> volumes(mesh.ElementIds.size(), 0.0);
  ForEach(runtime, static_cast<Index>(volumes.size()),
    [&](Index e)
    {
      if (grid.Owned().Contains(CellOfElement(grid, mesh, mesh.ElementIds[e])))
      {
        volumes[e] = VolumeOfElement(mesh, e, width);
      }
    });
  std::vector<ExactSum> sums(fragments + 1);
  for (std::size_t e = 0; e < volumes.size(); ++e)
  {
    sums[mesh.Fragment[e]].Add(volumes[e]);
  }
  return SumOverRanks(sums, runtime.Group());
}

} // namespace vfm
