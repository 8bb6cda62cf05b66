#include "Elements/MeasureFragments.h"

#include "Base/ExactSum.h"
#include "Base/HexVolume.h"

namespace vfm
{

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
  return VolumeOfHex(x, 1.0 / unit);
}

std::vector<double> MeasureFragments(
  const Mesh& mesh, const CartesianGrid& grid, const FragmentShare& share, Runtime& runtime)
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
  std::vector<ExactSum> sums(share.Size());
  for (std::size_t e = 0; e < volumes.size(); ++e)
  {
    sums[mesh.Fragment[e]].Add(volumes[e]);
  }
  return share.Sum(std::move(sums));
}

} // namespace vfm
