/**
 * Meshes an image of labels with cells of several widths: counts of elements, CPU seconds and the
 * share of them that replacing the cells takes, quality, volumes of labels, and for grains the
 * distance of nodes between two of them from the true planes.
 *
 * usage: ElementSizes IMAGE [METHODS, default hexes,Lattice] [WIDTHS, default
 *   0,1.5,2,3,4,auto:0.5,auto:0.25,coarsen]
 *
 * IMAGE is a file, or grains:N for the cells nearest to each of 12 seeds in N^3 voxels. WIDTHS are
 * CellWidth in voxels, auto:ERROR for MaterialWidths auto with an AllowedError, or coarsen for
 * Refinement Coarsen.
 */
#include "Base/ParseText.h"
#include "LabelInput.h"
#include "ReadLabelImage.h"
#include "SerialTimes.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <set>

using namespace vfm;
using namespace vfm::testing;

namespace
{

/// Seeds of grains, relative to the image: numpy.random.default_rng(1).random((12, 3)).
constexpr std::array<Vector3, 12> Seeds{ {
  { { 0.511822, 0.950464, 0.144160 } },
  { { 0.948649, 0.311831, 0.423326 } },
  { { 0.827703, 0.409199, 0.549594 } },
  { { 0.027559, 0.753513, 0.538143 } },
  { { 0.329732, 0.788429, 0.303195 } },
  { { 0.453498, 0.134042, 0.403113 } },
  { { 0.203455, 0.262313, 0.750365 } },
  { { 0.280409, 0.485191, 0.980737 } },
  { { 0.961657, 0.724790, 0.541227 } },
  { { 0.276891, 0.160652, 0.969925 } },
  { { 0.516069, 0.115866, 0.623490 } },
  { { 0.776683, 0.613003, 0.917298 } },
} };

struct Image
{
  Index3 Cells;
  std::vector<int> Labels; ///< of all voxels, x fastest
  bool AreGrains;
};

Image MakeGrains(Index size)
{
  Image image{ { { size, size, size } }, {}, true };
  ForCells({ {}, image.Cells },
    [&](const Index3& cell)
    {
      std::vector<double> squares(Seeds.size(), 0.0);
      for (std::size_t s = 0; s < Seeds.size(); ++s)
      {
        for (int a = 0; a < 3; ++a)
        {
          const double x = (static_cast<double>(cell[a]) + 0.5) / static_cast<double>(size);
          squares[s] += std::pow(x - Seeds[s][a], 2);
        }
      }
      const auto nearest = std::min_element(squares.begin(), squares.end());
      image.Labels.push_back(1 + static_cast<int>(nearest - squares.begin()));
    });
  return image;
}

Image ReadImage(const std::string& path)
{
  const LabelImage read = ReadLabelImage(path, 0);
  Image image{ read.Grid.Owned().Upper, {}, false };
  ForCells(read.Grid.Owned(),
    [&](const Index3& cell) { image.Labels.push_back(read.Labels.Label(read.Grid.Linear(cell))); });
  return image;
}

MesherOptions OptionsOf(const std::string& method, const std::string& width)
{
  MesherOptions options;
  options.Elements = method == "hexes" ? ElementKind::Hexes : ElementKind::Tets;
  options.Method = method == "Cells" ? TetMethod::Cells : TetMethod::Lattice;
  if (width.rfind("auto:", 0) == 0)
  {
    options.MaterialWidths = "auto";
    options.AllowedError = std::atof(width.c_str() + 5);
  }
  else if (width == "coarsen")
  {
    options.Refinement = RefinementMode::Coarsen;
  }
  else
  {
    options.CellWidth = width;
  }
  return options;
}

/// Returns the rms distance of points between two grains from the plane half way between their
/// seeds.
double FindDistance(const Mesh& mesh, double size)
{
  std::map<Index, std::set<int>> materials; // of points
  for (std::size_t e = 0; e < mesh.Material.size(); ++e)
  {
    for (int c = 0; c < mesh.Corners; ++c)
    {
      materials[mesh.Elements[e * mesh.Corners + c]].insert(mesh.Material[e]);
    }
  }
  double squares = 0.0;
  Index count = 0;
  for (const auto& [point, around] : materials)
  {
    if (around.size() == 2)
    {
      const Vector3 &one = Seeds[*around.begin() - 1], &other = Seeds[*around.rbegin() - 1];
      double length = 0.0, along = 0.0;
      for (int a = 0; a < 3; ++a)
      {
        const double step = other[a] - one[a];
        along += step * (mesh.Points[3 * point + a] - 0.5 * size * (one[a] + other[a]));
        length += step * step;
      }
      squares += along * along / length;
      ++count;
    }
  }
  return std::sqrt(squares / static_cast<double>(count));
}

/// Volumes of labels in a mesh.
struct Volumes
{
  double Worst = 0.0;          ///< largest error, relative
  Index Lost = 0;              ///< labels of 30 voxels and more without elements
  Index Off = 0, OffOf100 = 0; ///< labels off by more than 1 %: all; of 100 voxels and more
};

Volumes MeasureVolumes(const MeshReport& report)
{
  Volumes volumes;
  for (std::size_t m = 1; m < report.TargetVolume.size(); ++m)
  {
    const double voxels = report.TargetVolume[m];
    const double error = voxels > 0.0 ? std::fabs(report.MeshVolume[m] / voxels - 1.0) : 0.0;
    volumes.Worst = std::max(volumes.Worst, error);
    volumes.Lost += voxels > 29.5 && report.MeshVolume[m] == 0.0;
    volumes.Off += error > 0.01;
    volumes.OffOf100 += error > 0.01 && voxels > 99.5;
  }
  return volumes;
}

/// Returns the share of CPU seconds in which cells are replaced.
double ShareOfNewCells(const SerialTimes& times)
{
  double all = 0.0, replacing = 0.0;
  for (const auto& [stage, time] : times)
  {
    all += time.Total();
    replacing += stage == "Replacing cells by wider ones" ? time.Total() : 0.0;
  }
  return replacing / all;
}

void Measure(const Image& image, const std::string& method, const std::string& width)
{
  TimedRuntime runtime(1);
  MesherInput input = MakeLabelInput({ image.Cells, 0.0, 1.0 }, image.Labels, runtime.Group());
  const double begin = CpuSeconds(CLOCK_PROCESS_CPUTIME_ID);
  const MesherResult result = RunMesher(input, OptionsOf(method, width), runtime);
  const double seconds = CpuSeconds(CLOCK_PROCESS_CPUTIME_ID) - begin;
  const MeshReport& report = result.Report;
  const Volumes volumes = MeasureVolumes(report);
  std::printf("| %s | %s | %zu | %.2f | %.1f | ", method.c_str(), width.c_str(),
    result.TheMesh.ElementIds.size(), seconds, 100.0 * ShareOfNewCells(runtime.Times()));
  if (method == "hexes")
  {
    std::printf("%.3f", report.MinimumScaledJacobian);
  }
  else
  {
    std::printf("%.1f-%.1f", report.MinimumDihedralAngle, report.MaximumDihedralAngle);
  }
  std::printf(" | %.1e | %lld | %lld, %lld | ", 100.0 * volumes.Worst,
    static_cast<long long>(volumes.Lost), static_cast<long long>(volumes.Off),
    static_cast<long long>(volumes.OffOf100));
  if (image.AreGrains)
  {
    std::printf("%.3f", FindDistance(result.TheMesh, static_cast<double>(image.Cells[0])));
  }
  std::printf(" |\n");
  std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv)
{
  if (argc < 2)
  {
    std::fprintf(stderr, "usage: ElementSizes IMAGE|grains:N [METHODS] [WIDTHS]\n");
    return 2;
  }
  const std::string name = argv[1];
  const bool areGrains = name.rfind("grains:", 0) == 0;
  const Image image = areGrains ? MakeGrains(std::atoi(name.c_str() + 7)) : ReadImage(name);
  std::printf("| elements | width | count | CPU s | %% new cells | scaled Jacobian or angles | "
              "worst volume %% | lost | off, of 100 voxels | distance |\n"
              "|---|---|---|---|---|---|---|---|---|---|\n");
  for (const std::string& method : SplitText(argc > 2 ? argv[2] : "hexes,Lattice"))
  {
    for (const std::string& width :
      SplitText(argc > 3 ? argv[3] : "0,1.5,2,3,4,auto:0.5,auto:0.25,coarsen"))
    {
      Measure(image, method, width);
    }
  }
  return 0;
}
