/**
 * Meshes an image of labels and compares the mesh with the cells: fragments, pairs of fragments
 * that touch, area to the void, volumes of labels; counts elements that overlap and elements with
 * all points on surfaces. Lists the labels whose volume is off by more than 1 %.
 *
 * usage: LabelImages IMAGE CELLS [METHODS, default hexes,Lattice,Cells] [PASSES, default 0,3]
 *
 * IMAGE is a file, or `atlas` for an artificial one (Support/Atlas.h); CELLS the size of the cube
 * in its middle, 0 for the whole image; PASSES a list of label smoothings.
 */
#include "Atlas.h"
#include "Base/ParseText.h"
#include "Labels/Fragments.h"
#include "MeshChecks.h"
#include "OverlapChecks.h"
#include "Phases/MeshOfCells.h"
#include "ReadLabelImage.h"
#include "RealCases.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <limits>

using namespace vfm;
using namespace vfm::testing;

namespace
{

LabelImage MakeArtificialImage(Index cells)
{
  CartesianGrid grid = MakeUnitGrid(cells);
  FractionField labels = MakeAtlas(grid, static_cast<int>(cells * cells / 36), 1);
  return { std::move(grid), std::move(labels), {} };
}

double AreaToVoid(const Mesh& mesh)
{
  double area = 0.0;
  for (std::size_t s = 0; s < mesh.Tables.SurfaceAreas.size(); ++s)
  {
    const bool isFree = mesh.Tables.SurfaceSides[s] < 0 && mesh.Tables.SurfaceMaterials[s][0] == 0;
    area += isFree ? mesh.Tables.SurfaceAreas[s] : 0.0;
  }
  return area;
}

MeshOptions OptionsOf(const std::string& method)
{
  MeshOptions options;
  options.Method = method == "Cells" ? TetMethod::Cells : TetMethod::Lattice;
  return options;
}

/// Sizes of labels, in voxels: classes from each size to the next.
constexpr std::array<Index, 7> SizeClasses{ { 1, 5, 8, 30, 100, 500,
  std::numeric_limits<Index>::max() } };

constexpr double LargestError = 0.01; ///< of the volume of a label, relative

/// Size of a label in the image.
struct LabelSize
{
  Index Voxels = 0;
  Index Pieces = 0; ///< sets of voxels joined by faces
};

/// Returns the size of each label.
std::vector<LabelSize> MeasureLabels(const LabelImage& image)
{
  std::vector<LabelSize> sizes(image.Labels.NumberOfMaterials() + 1);
  ForCells(image.Grid.Owned(),
    [&](const Index3& cell) { ++sizes[image.Labels.Label(image.Grid.Linear(cell))].Voxels; });
  Ranks alone;
  const Fragments fragments(image.Grid, AssignMaterials(image.Grid, image.Labels, 0.5), false,
    Partition(image.Grid, alone));
  for (int f = 1; f <= fragments.NumberOfFragments(); ++f)
  {
    ++sizes[fragments.MaterialsOfFragments()[f]].Pieces;
  }
  return sizes;
}

/// Returns the error of the volume of a label, relative.
double VolumeErrorOf(const MeshReport& report, std::size_t label)
{
  return report.MeshVolume[label] / report.TargetVolume[label] - 1.0;
}

/// Returns the columns of the table of volumes: lost labels, then for each class the labels, those
/// off by more than LargestError, and the largest error.
std::string ListVolumes(const std::vector<LabelSize>& sizes, const MeshReport& report)
{
  Index lost = 0;
  for (std::size_t l = 1; l < sizes.size(); ++l)
  {
    lost += sizes[l].Voxels > 0 && report.MeshVolume[l] == 0.0;
  }
  std::string row = std::to_string(lost);
  for (std::size_t c = 0; c + 1 < SizeClasses.size(); ++c)
  {
    Index labels = 0, off = 0;
    double worst = 0.0;
    for (std::size_t l = 1; l < sizes.size(); ++l)
    {
      if (sizes[l].Voxels >= SizeClasses[c] && sizes[l].Voxels < SizeClasses[c + 1])
      {
        const double error = std::fabs(VolumeErrorOf(report, l));
        ++labels;
        off += error > LargestError;
        worst = std::max(worst, error);
      }
    }
    char text[80];
    std::snprintf(text, sizeof(text), " | %lld, %lld, %.2f", static_cast<long long>(labels),
      static_cast<long long>(off), 100.0 * worst);
    row += text;
  }
  return row;
}

/// Returns the rows of the labels that are off by more than LargestError; each begins with `run`.
std::string ListLabelsOff(const LabelImage& image, const std::vector<LabelSize>& sizes,
  const MeshReport& report, const std::string& run)
{
  std::string rows;
  for (std::size_t l = 1; l < sizes.size(); ++l)
  {
    const double error = VolumeErrorOf(report, l);
    if (sizes[l].Voxels > 0 && std::fabs(error) > LargestError)
    {
      const long long name = image.Names.empty() ? static_cast<long long>(l) : image.Names[l];
      char text[160];
      std::snprintf(text, sizeof(text), "%lld | %lld | %lld | %lld | %lld | %+.1f |\n", name,
        static_cast<long long>(sizes[l].Voxels), static_cast<long long>(sizes[l].Pieces),
        static_cast<long long>(report.LostCells[l]), static_cast<long long>(report.GainedCells[l]),
        100.0 * error);
      rows += run + text;
    }
  }
  return rows;
}

/// Rows of tables after the first.
struct MoreRows
{
  std::string Volumes, LabelsOff;
};

/// Prints a row of the first table and appends rows to the others.
void Measure(const LabelImage& image, const FractionField& fractions, int passes,
  const std::string& method, const std::vector<LabelSize>& sizes, MoreRows& more)
{
  const MeshOptions options = OptionsOf(method);
  Runtime runtime;
  MeshReport report;
  const bool hasHexes = method == "hexes";
  const std::clock_t begin = std::clock();
  const Mesh mesh =
    (hasHexes ? MakeHexMesh : MakeTetMesh)(image.Grid, fractions, options, runtime, report);
  const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  const std::string problem =
    FindCellProblem(image.Grid, mesh, MakeCells(image.Grid, fractions, options));
  const ElementOverlaps overlaps = FindElementOverlaps(mesh);
  std::printf("| %s | %d | %.1f | %zu | %lld | %s | %.0f | %lld, %.2g | %lld | %lld | ",
    method.c_str(), passes, seconds, mesh.ElementIds.size(),
    static_cast<long long>(report.NumberOfFragments), problem.empty() ? "equal" : problem.c_str(),
    AreaToVoid(mesh), static_cast<long long>(overlaps.Pairs), overlaps.Depth,
    static_cast<long long>(CountCoincidentPoints(mesh)), static_cast<long long>(CountLocked(mesh)));
  if (hasHexes)
  {
    std::printf("%.3f |\n", report.MinimumScaledJacobian);
  }
  else
  {
    std::printf("%.1f-%.1f |\n", report.MinimumDihedralAngle, report.MaximumDihedralAngle);
  }
  std::fflush(stdout);
  const std::string run = "| " + method + " | " + std::to_string(passes) + " | ";
  more.Volumes += run + ListVolumes(sizes, report) + " |\n";
  more.LabelsOff += ListLabelsOff(image, sizes, report, run);
}

} // namespace

int main(int argc, char** argv)
{
  if (argc < 3)
  {
    std::fprintf(stderr, "usage: LabelImages IMAGE CELLS [METHODS] [PASSES]\n");
    return 2;
  }
  const std::string path = argv[1];
  const Index cells = std::atoi(argv[2]);
  const LabelImage image =
    path == "atlas" ? MakeArtificialImage(cells) : ReadLabelImage(path, cells);
  std::printf("| method | label smoothing | CPU s | elements | fragments | fragments and pairs of "
              "the cells | area to the void | overlaps, depth | coincident points | locked | "
              "smallest scaled Jacobian; dihedral angles |\n"
              "|---|---|---|---|---|---|---|---|---|---|---|\n");
  const std::vector<LabelSize> sizes = MeasureLabels(image);
  MoreRows more;
  for (const std::string& word : SplitText(argc > 4 ? argv[4] : "0,3"))
  {
    const int passes = std::atoi(word.c_str());
    const FractionField fractions = MakeSmoothedCase(image.Grid, image.Labels, passes).Fractions;
    for (const std::string& method : SplitText(argc > 3 ? argv[3] : "hexes,Lattice,Cells"))
    {
      Measure(image, fractions, passes, method, sizes, more);
    }
  }
  std::printf("\nPer class of voxels: labels, off by more than 1 %%, largest error in %%.\n\n"
              "| method | label smoothing | lost | 1 to 4 | 5 to 7 | 8 to 29 | 30 to 99 | "
              "100 to 499 | 500 and more |\n|---|---|---|---|---|---|---|---|---|\n%s",
    more.Volumes.c_str());
  std::printf(
    "\nLabels off by more than 1 %%. Pieces are joined by faces; lost and gained cells are "
    "those of other labels that make interfaces manifold.\n\n"
    "| method | label smoothing | label | voxels | pieces | cells lost | cells gained | "
    "error in %% |\n|---|---|---|---|---|---|---|---|\n%s",
    more.LabelsOff.c_str());
  return 0;
}
