/// Meshes a ball by the pipelines of Mesher, as hexahedra and by each tetrahedral
/// method, and prints the volumes.
#include <Phases/MeshOfCells.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace
{

constexpr int Size = 12;

/// Reader of a ball in unit cells; the distance of the cell centre determines the fraction.
class Ball : public vfm::FractionField::Reader
{
public:
  void Read(int, const vfm::Index3& first, vfm::Index count, double* values) const override
  {
    for (vfm::Index i = 0; i < count; ++i)
    {
      double square = 0.0;
      for (int a = 0; a < 3; ++a)
      {
        const double x = static_cast<double>(first[a]) + (a == 0 ? i : 0) + 0.5 - 0.5 * Size;
        square += x * x;
      }
      values[i] = std::min(1.0, std::max(0.0, 4.5 - std::sqrt(square)));
    }
  }
  std::string Name(int) const override { return "ball"; }
};

} // namespace

int main()
{
  std::vector<double> nodes;
  for (int i = 0; i <= Size; ++i)
  {
    nodes.push_back(i);
  }
  const vfm::CartesianGrid grid(std::array<std::vector<double>, 3>{ { nodes, nodes, nodes } });
  const auto fractions = vfm::FractionField::FromReader(grid, 1, Ball());
  vfm::Runtime runtime;
  vfm::MeshOptions options;
  vfm::MeshReport report;
  const vfm::Mesh hexes = vfm::MakeHexMesh(grid, fractions, options, runtime, report);
  std::printf("%zu hexes, volume %.4f of %.4f\n", hexes.Material.size(), report.MeshVolume.at(1),
    report.TargetVolume.at(1));
  for (auto method : { vfm::TetMethod::Lattice,
#ifdef VFM_HAS_TETGEN
         vfm::TetMethod::TetGen,
#endif
         vfm::TetMethod::Cells })
  {
    options.Method = method;
    vfm::MeshReport tetReport;
    const vfm::Mesh tets = vfm::MakeTetMesh(grid, fractions, options, runtime, tetReport);
    std::printf("%zu tets, volume %.4f of %.4f\n", tets.Material.size(), tetReport.MeshVolume.at(1),
      tetReport.TargetVolume.at(1));
  }
  return 0;
}
