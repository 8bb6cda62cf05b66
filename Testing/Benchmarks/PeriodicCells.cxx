/**
 * Periodic cells: a ball across the corner of the cell and in its middle, a gyroid and a
 * polycrystal, meshed as one period with flat and with free sides, and without the option.
 *
 * usage: PeriodicCells [n, cells along each axis, default 32]
 *
 * Seconds are CPU seconds of one thread, over those without the option.
 */
#include "Base/Vector3.h"
#include "GluedChecks.h"
#include "Phases/MeshOfCells.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>

using namespace vfm;
using namespace vfm::testing;

namespace
{

/// A body in one period of length 1, by its label at a point.
struct Body
{
  const char* Name;
  int Materials;
  std::function<int(const Vector3&)> Label;
};

/// Returns a ball of a volume of 0.18.
Body MakeBall(const char* name, double middle)
{
  return { name, 1,
    [middle](const Vector3& x)
    {
      double squares = 0.0;
      for (double coordinate : x)
      {
        const double away = std::fabs(coordinate - middle);
        squares += std::pow(std::min(away, 1.0 - away), 2);
      }
      return squares < 0.35 * 0.35 ? 1 : 0;
    } };
}

Body MakeGyroidBody()
{
  return { "gyroid", 2,
    [](const Vector3& x)
    {
      const auto sine = [&x](int a) { return std::sin(2.0 * M_PI * x[a]); };
      const auto cosine = [&x](int a) { return std::cos(2.0 * M_PI * x[a]); };
      return sine(0) * cosine(1) + sine(1) * cosine(2) + sine(2) * cosine(0) > 0.0 ? 1 : 2;
    } };
}

struct Result
{
  Mesh TheMesh;
  MeshReport Report;
  double Seconds;
};

Result Run(const CartesianGrid& grid, const FractionField& field, bool ofHexes)
{
  Runtime alone;
  Result result;
  const std::clock_t start = std::clock();
  result.TheMesh =
    (ofHexes ? MakeHexMesh : MakeTetMesh)(grid, field, MeshOptions(), alone, result.Report);
  result.Seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  return result;
}

/// Returns the largest relative error of the volume of a material.
double WorstVolume(const MeshReport& report)
{
  double worst = 0.0;
  for (std::size_t m = 1; m < report.TargetVolume.size(); ++m)
  {
    worst = std::max(worst, std::fabs(report.MeshVolume[m] / report.TargetVolume[m] - 1.0));
  }
  return worst;
}

std::string FormatAngles(const MeshReport& report)
{
  char text[32];
  std::snprintf(
    text, sizeof(text), "%.1f to %.1f", report.MinimumDihedralAngle, report.MaximumDihedralAngle);
  return text;
}

void Print(const char* name, const char* sides, bool ofHexes, const Result& result, double alone)
{
  std::printf("| %s | %s | %s | %zu | %lld | %.3f | %s | %.0e | %.2f |\n", name,
    ofHexes ? "hexes" : "Lattice", sides, result.TheMesh.ElementIds.size(),
    static_cast<long long>(result.Report.NumberOfFragments), result.Report.MinimumScaledJacobian,
    ofHexes ? "" : FormatAngles(result.Report).c_str(), WorstVolume(result.Report),
    result.Seconds / alone);
  std::fflush(stdout);
}

/// Meshes a field without the option, and with each kind of sides.
void Measure(
  const char* name, Index n, const std::function<FractionField(const CartesianGrid&)>& makeField)
{
  for (const bool ofHexes : { true, false })
  {
    const CartesianGrid box = MakePeriodicGrid({ { n, n, n } }, { { false, false, false } });
    const Result alone = Run(box, makeField(box), ofHexes);
    Print(name, "box", ofHexes, alone, alone.Seconds);
    for (const Seam seam : { Seam::Flat, Seam::Free })
    {
      const CartesianGrid grid = MakePeriodicGrid({ { n, n, n } }, { { true, true, true } }, seam);
      const Result result = Run(grid, makeField(grid), ofHexes);
      Print(name, seam == Seam::Flat ? "flat" : "free", ofHexes, result, alone.Seconds);
    }
  }
}

} // namespace

int main(int argc, char** argv)
{
  const Index n = argc > 1 ? std::atoi(argv[1]) : 32;
  std::printf("| %lld^3 cells | mesh | sides | elements | fragments | min SJ | dihedral angles | "
              "worst volume | time |\n|---|---|---|---|---|---|---|---|---|\n",
    static_cast<long long>(n));
  for (const Body& body :
    { MakeBall("ball in the middle", 0.5), MakeBall("ball at the corner", 0.0), MakeGyroidBody() })
  {
    Measure(body.Name, n,
      [&](const CartesianGrid& grid)
      {
        return SamplePeriodic(grid, body.Materials, 8,
          [&](const Vector3& x) { return body.Label((1.0 / static_cast<double>(n)) * x); });
      });
  }
  Measure(
    "20 grains", n, [](const CartesianGrid& grid) { return MakePeriodicPolycrystal(grid, 1); });
  return 0;
}
