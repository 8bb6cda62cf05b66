/**
 * Meshes of a plane: a disc, maps of grains and noise as quadrilaterals and triangles.
 *
 * usage: FlatMeshes [n, cells of the map along each axis, default 600] [its grains, default 13364]
 *                   [threads, default 1]
 *
 * Worst area: relative error of the area of a fragment of at least two cells. Fragments, off:
 * number of those, and how many of them miss their areas by more than 1e-6. Tiny fragments are
 * smaller ones. Seconds are of wall time, all stages from the cells to the elements.
 */
#include "Base/ThreadRuntime.h"
#include "Base/Vector3.h"
#include "Input/PlainArrays.h"
#include "LabelInput.h"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>

using namespace vfm;
using namespace vfm::testing;

namespace
{

constexpr double Width = 0.5;

/// Returns labels of n x n cells of grains: the nearest of random points, which are sought in the
/// squares around each cell.
std::vector<int> MakeGrains(int n, int grains, unsigned seed)
{
  std::mt19937 random(seed);
  const int squares = std::max(1, static_cast<int>(std::sqrt(grains / 2.0)));
  std::vector<std::vector<std::array<double, 3>>> points(squares * squares);
  for (int g = 1; g <= grains; ++g)
  {
    const double x = random() / 4294967296.0, y = random() / 4294967296.0;
    points[static_cast<int>(squares * x) + squares * static_cast<int>(squares * y)].push_back(
      { { n * x, n * y, static_cast<double>(g) } });
  }
  std::vector<int> labels;
  for (int cell = 0; cell < n * n; ++cell)
  {
    const double x = cell % n + 0.5, y = cell / n + 0.5;
    const int u = static_cast<int>(squares * x / n), v = static_cast<int>(squares * y / n);
    double least = 1e300;
    int label = 0;
    for (int at = 0; at < 49; ++at)
    {
      const int i = u + at % 7 - 3, j = v + at / 7 - 3;
      if (i < 0 || j < 0 || i >= squares || j >= squares)
      {
        continue;
      }
      for (const std::array<double, 3>& point : points[i + squares * j])
      {
        const double square = std::pow(x - point[0], 2) + std::pow(y - point[1], 2);
        label = square < least ? static_cast<int>(point[2]) : label;
        least = std::min(least, square);
      }
    }
    labels.push_back(label);
  }
  return labels;
}

std::vector<int> MakeNoise(int n)
{
  std::mt19937 random(2);
  std::vector<int> labels(n * n);
  for (int& label : labels)
  {
    label = 1 + static_cast<int>(random() % 8);
  }
  return labels;
}

/// Returns fractions of a disc of a radius of 10 cells in 32 x 32 cells.
MesherInput MakeDisc(Ranks& ranks)
{
  constexpr int N = 32, Samples = 32;
  std::vector<double> fractions;
  for (int cell = 0; cell < N * N; ++cell)
  {
    int inside = 0;
    for (int s = 0; s < Samples * Samples; ++s)
    {
      const double x = cell % N + (s % Samples + 0.5) / Samples - 15.7;
      const double y = cell / N + (s / Samples + 0.5) / Samples - 16.2;
      inside += x * x + y * y < 100.0;
    }
    fractions.push_back(inside / double(Samples * Samples));
  }
  auto arrays = std::make_shared<PlainArrays>(static_cast<Index>(fractions.size()));
  arrays->Store("disc", ValueType::Double, std::move(fractions));
  MesherInput input = MakeInput(
    { MakeBlock({ { { 0, 0, 0 } }, { { N, N, 1 } } }, { { 0, 0, 0 } }, Width, arrays) }, ranks);
  input.Arrays.Fractions = { "disc" };
  return input;
}

MesherInput MakeMap(int n, const std::vector<int>& labels, Ranks& ranks)
{
  return MakeLabelInput({ { { n, n, 1 } }, 0.0, Width }, labels, ranks);
}

/// What is known of a mesh.
struct Figures
{
  double LeastAngle = 180.0, LargestAngle = 0.0, WorstArea = 0.0;
  int Fragments = 0, Off = 0, Tiny = 0, TinyOff = 0;
};

Figures Measure(const MesherResult& result)
{
  const Mesh& mesh = result.TheMesh;
  Figures figures;
  std::vector<double> areas(result.Report.Fragments.Volumes.size(), 0.0);
  for (std::size_t e = 0; e < mesh.ElementIds.size(); ++e)
  {
    const auto at = [&](int c)
    { return mesh.PointAt(mesh.Elements[mesh.Corners * e + c % mesh.Corners]); };
    for (int c = 0; c < mesh.Corners; ++c)
    {
      const Vector3 a = at(c + 1) - at(c), b = at(c + mesh.Corners - 1) - at(c);
      const double angle = std::atan2(Cross(a, b)[2], Dot(a, b)) * 180.0 / M_PI;
      figures.LeastAngle = std::min(figures.LeastAngle, angle);
      figures.LargestAngle = std::max(figures.LargestAngle, angle);
      areas[mesh.Fragment[e] - 1] += 0.5 * Cross(at(c), at(c + 1))[2];
    }
  }
  for (std::size_t f = 0; f < areas.size(); ++f)
  {
    const double target = result.Report.Fragments.Volumes[f];
    const double error = std::fabs(areas[f] / target - 1.0);
    const bool isTiny = target < 2.0 * Width * Width;
    (isTiny ? figures.Tiny : figures.Fragments) += 1;
    (isTiny ? figures.TinyOff : figures.Off) += error > 1e-6;
    figures.WorstArea = isTiny ? figures.WorstArea : std::max(figures.WorstArea, error);
  }
  return figures;
}

void PrintCase(
  const std::string& name, const MesherInput& input, MesherOptions options, Runtime& runtime)
{
  options.Flat = true;
  for (const ElementKind kind : { ElementKind::Hexes, ElementKind::Tets })
  {
    options.Elements = kind;
    const auto start = std::chrono::steady_clock::now();
    const MesherResult result = RunMesher(input, options, runtime);
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    const Figures figures = Measure(result);
    std::printf("| %s | %s | %zu | %.3f | %.1f to %.1f | %.1e | %d, %d | %d, %d | %.2f |\n",
      name.c_str(), kind == ElementKind::Hexes ? "quadrilaterals" : "triangles",
      result.TheMesh.ElementIds.size(), result.Report.MinimumScaledJacobian, figures.LeastAngle,
      figures.LargestAngle, figures.WorstArea, figures.Fragments, figures.Off, figures.Tiny,
      figures.TinyOff, time.count());
  }
}

} // namespace

int main(int argc, char** argv)
{
  const int n = argc > 1 ? std::atoi(argv[1]) : 600;
  const int grains = argc > 2 ? std::atoi(argv[2]) : 13364;
  ThreadRuntime runtime(argc > 3 ? std::atoi(argv[3]) : 1);
  Ranks& ranks = runtime.Group();
  std::printf(
    "| case | elements | number | smallest scaled Jacobian | angles | worst area | "
    "fragments, off | tiny fragments, off | s |\n|---|---|---|---|---|---|---|---|---|\n");
  MesherOptions fractions, labels;
  PrintCase("disc", MakeDisc(ranks), fractions, runtime);
  fractions.MeshVoid = true;
  PrintCase("disc in void", MakeDisc(ranks), fractions, runtime);
  labels.LabelSmoothing = 3;
  PrintCase("100 grains", MakeMap(80, MakeGrains(80, 100, 1), ranks), labels, runtime);
  MesherOptions periodic = labels;
  periodic.Periodic = 3;
  PrintCase("100 grains, periodic", MakeMap(80, MakeGrains(80, 100, 1), ranks), periodic, runtime);
  PrintCase("noise of 8 labels", MakeMap(64, MakeNoise(64), ranks), {}, runtime);
  PrintCase(std::to_string(grains) + " grains", MakeMap(n, MakeGrains(n, grains, 3), ranks), labels,
    runtime);
  return 0;
}
