/**
 * Effect of option SharpEdges on edges and corners, and on shapes without edges.
 *
 * usage: SharpEdges table|controls [METHOD[:TARGET] [Off,On,Automatic [case...]]]
 *   SharpEdges table hexes Off,On "cube A 32" "L 16"
 *
 * METHOD is hexes, Lattice or Cells; TARGET the target scaled Jacobian, default automatic.
 *
 * table: one row per solid, number of cells and option. Distances are in cells, as
 * largest/root mean square: interface nodes to the true surface, facets to the true surface,
 * true edges to the facets (with the 99th percentile), true edges to the nearest node, true
 * corners to the nearest node (largest). Then follow the numbers of points attached to edges
 * and to corners, and the geometry.
 *
 * controls: number of points that the option moves, and its cost in alternating runs.
 */
#include "Base/ParseText.h"
#include "Base/Vector3.h"
#include "MeasureAlone.h"
#include "MeshCases.h"
#include "RandomDraw.h"
#include "SharpCases.h"

#include <cstdio>
#include <cstring>
#include <sstream>

using namespace vfm;
using namespace vfm::testing;

namespace
{

using Names = std::vector<std::string>;

constexpr int Rounds = 3;       ///< alternating runs; the smallest time of each option counts
constexpr double LongRun = 5.0; ///< seconds; longer runs are not repeated

const Names TableCases{ "cube A 16", "cube A 32", "cube A 64", "cube B 16", "cube B 32",
  "cube B 64", "cube C 16", "cube C 32", "cube C 64", "cube D 16", "cube D 32", "cube D 64", "L 16",
  "L 32", "L 64", "cylinder 16", "cylinder 32", "cylinder 64", "wedge 45 16", "wedge 45 32",
  "cube A in matrix 32" };
const Names Controls{ "sphere 32", "sphere 8", "torus", "gyroid", "polycrystal", "ball and plate",
  "ball of 3 sectors", "two spheres, gap .3", "smooth noise 40", "label noise 40" };

/// Returns the number after the last blank of a name such as "cube A 32".
int CellsOf(const std::string& name)
{
  return std::atoi(name.c_str() + name.rfind(' ') + 1);
}

constexpr std::array<const char*, 3> ModeNames{ { "Off", "On", "Automatic" } };
const char* NameOf(SharpEdgeMode mode)
{
  return ModeNames[static_cast<int>(mode)];
}
/// Returns the modes given by names separated by commas.
std::vector<SharpEdgeMode> ListModes(const std::string& text)
{
  std::vector<SharpEdgeMode> modes;
  std::istringstream words(text);
  for (std::string word; std::getline(words, word, ',');)
  {
    const auto at = std::find(ModeNames.begin(), ModeNames.end(), word);
    if (at == ModeNames.end())
    {
      throw InputError("There is no option '" + word + "'.");
    }
    modes.push_back(static_cast<SharpEdgeMode>(at - ModeNames.begin()));
  }
  return modes;
}

/// Mesher and options of a method.
struct Method
{
  MeshMaker Make = MakeHexMesh;
  MeshOptions Options;
};
Method MethodOf(const std::string& text)
{
  const std::size_t colon = text.find(':');
  const std::string name = text.substr(0, colon);
  const std::optional<double> target =
    colon == std::string::npos ? 0.0 : ParseNumber(text.substr(colon + 1), 0.0, 0.99);
  if (!target || (name != "hexes" && name != "Lattice" && name != "Cells"))
  {
    throw InputError("There is no method '" + text + "'.");
  }
  Method method;
  method.Options.TargetScaledJacobian = *target;
  if (name == "hexes")
  {
    return method;
  }
  method.Make = MakeTetMesh;
  method.Options.Method = name == "Cells" ? TetMethod::Cells : TetMethod::Lattice;
  return method;
}

struct TimedMesh
{
  Mesh Result;
  MeshReport Report;
  double Seconds = 0.0;
};
TimedMesh MakeTimed(
  const CartesianGrid& grid, const FractionField& fractions, Method method, SharpEdgeMode mode)
{
  method.Options.SharpEdges = mode;
  Runtime runtime;
  TimedMesh timed;
  const double begin = Now();
  timed.Result = method.Make(grid, fractions, method.Options, runtime, timed.Report);
  timed.Seconds = Now() - begin;
  return timed;
}

double SecondsOfFeatures(const MeshReport& report)
{
  double seconds = 0.0;
  for (const MeshReport::Stage& stage : report.Stages)
  {
    seconds += std::strcmp(stage.Name, "Finding sharp features") == 0 ? stage.Seconds : 0.0;
  }
  return seconds;
}

std::string FormatQuality(const TimedMesh& timed)
{
  char text[64];
  const MeshReport& r = timed.Report;
  if (timed.Result.Corners == 4)
  {
    std::snprintf(text, sizeof(text), "%.1f..%.1f", r.MinimumDihedralAngle, r.MaximumDihedralAngle);
  }
  else
  {
    std::snprintf(text, sizeof(text), "%.3f/%.3f", r.MinimumScaledJacobian, r.MeanScaledJacobian);
  }
  return text;
}

std::string FormatCarriers(const MeshReport& report)
{
  return std::to_string(report.EdgePoints) + "+" + std::to_string(report.CornerPoints);
}

void PrintTable(const Method& method, const std::vector<SharpEdgeMode>& modes, const Names& cases)
{
  std::printf("| case | | %s | nodes | surface | edges to surface | edges to node | corners | "
              "volume | points on edges+corners | surfaces+curves+vertices | s (creases) |\n"
              "|---|---|---|---|---|---|---|---|---|---|---|---|\n",
    method.Make == MakeTetMesh ? "dihedral angles" : "SJ min/mean");
  for (const std::string& name : cases)
  {
    const SharpCase c = MakeSharpCase(name.substr(0, name.rfind(' ')), CellsOf(name));
    for (SharpEdgeMode mode : modes)
    {
      const TimedMesh timed = MakeTimed(c.Grid, c.Fractions, method, mode);
      const SharpFigures f = MeasureSharp(c, timed.Result, timed.Report);
      std::printf("| %s | %s | %s | %.3f/%.4f | %.3f/%.4f | %.3f/%.3f (%.3f) | %.2f/%.3f | %.3f | "
                  "%.1e | %s | %lld+%lld+%lld | %.2f (%.2f) |\n",
        c.Name.c_str(), NameOf(mode), FormatQuality(timed).c_str(), f.NodesToSurface.Largest,
        f.NodesToSurface.RootMeanSquare, f.MeshToSurface.Largest, f.MeshToSurface.RootMeanSquare,
        f.EdgesToMesh.Largest, f.EdgesToMesh.RootMeanSquare, f.EdgesToMesh.Percentile99,
        f.EdgesToNodes.Largest, f.EdgesToNodes.RootMeanSquare, f.CornersToNodes.Largest,
        f.VolumeError, FormatCarriers(timed.Report).c_str(),
        static_cast<long long>(timed.Report.NumberOfSurfaces),
        static_cast<long long>(timed.Report.NumberOfCurves),
        static_cast<long long>(timed.Report.NumberOfVertices), timed.Seconds,
        SecondsOfFeatures(timed.Report));
      std::fflush(stdout);
    }
  }
}

/// Returns random fractions of cells, averaged over 27 neighbours and scaled to
/// 0..1: surfaces with no clear edges.
FractionField MakeSmoothNoise(const CartesianGrid& grid)
{
  constexpr double Spread = 4.0;
  const IndexBox& box = grid.Global();
  RandomDraw draw(1);
  std::vector<double> noise(box.NumberOfCells());
  for (double& value : noise)
  {
    value = draw.Between(0.0, 1.0);
  }
  FractionField field(grid, 1);
  ForCells(box,
    [&](const Index3& cell)
    {
      const IndexBox around = Grow({ cell, { { cell[0] + 1, cell[1] + 1, cell[2] + 1 } } }, 1, box);
      double sum = 0.0;
      ForCells(around, [&](const Index3& c) { sum += noise[IndexInBox(box, c)]; });
      const double mean = sum / around.NumberOfCells();
      const double fraction = std::min(1.0, std::max(0.0, .5 + Spread * (mean - .5)));
      if (fraction > 0.0)
      {
        field.SetParts(grid.Linear(cell), { { 1, fraction } });
      }
    });
  return field;
}

struct Control
{
  CartesianGrid Grid;
  FractionField Fractions;
};
Control MakeControl(const std::string& name)
{
  if (name.find("noise") == std::string::npos)
  {
    const MeshCase c = MakeMeshCase(name);
    return { c.Grid, c.Fractions };
  }
  const CartesianGrid grid = MakeUnitGrid(CellsOf(name));
  return { grid,
    name.find("smooth") == 0 ? MakeSmoothNoise(grid) : MakeRandomLabels(grid, 3, 0, 1) };
}

/// Number of points whose coordinates differ from another mesh, and of points
/// farther than a distance in cells.
struct MovedPoints
{
  Index Any = 0, Far = 0;
};
MovedPoints CountMoved(const Mesh& a, const Mesh& b)
{
  constexpr double FarFrom = 0.02;
  MovedPoints moved;
  for (std::size_t p = 0; p < a.PointIds.size(); ++p)
  {
    if (a.PointIds[p] != b.PointIds[p])
    {
      throw std::logic_error("The option has made other points.");
    }
    const double *x = a.Points.data() + 3 * p, *y = b.Points.data() + 3 * p;
    const double distance = Norm(Vector3{ { x[0] - y[0], x[1] - y[1], x[2] - y[2] } });
    moved.Any += distance > 0.0;
    moved.Far += distance > FarFrom;
  }
  return moved;
}

void PrintControls(
  const Method& method, const std::vector<SharpEdgeMode>& modes, const Names& cases)
{
  std::printf("| case | | %s | points on edges+corners | points | moved | moved > .02 | s "
              "(creases) | s / s of Off |\n"
              "|---|---|---|---|---|---|---|---|---|\n",
    method.Make == MakeTetMesh ? "dihedral angles" : "SJ min/mean");
  for (const std::string& name : cases)
  {
    const Control c = MakeControl(name);
    std::vector<double> seconds(modes.size() + 1, 1e300);
    TimedMesh off;
    std::vector<TimedMesh> meshes(modes.size());
    for (int round = 0; round == 0 || (round < Rounds && off.Seconds < LongRun); ++round)
    {
      off = MakeTimed(c.Grid, c.Fractions, method, SharpEdgeMode::Off);
      seconds.back() = std::min(seconds.back(), off.Seconds);
      for (std::size_t m = 0; m < modes.size(); ++m)
      {
        meshes[m] = MakeTimed(c.Grid, c.Fractions, method, modes[m]);
        seconds[m] = std::min(seconds[m], meshes[m].Seconds);
      }
    }
    for (std::size_t m = 0; m < modes.size(); ++m)
    {
      const MovedPoints moved = CountMoved(off.Result, meshes[m].Result);
      std::printf("| %s | %s | %s | %s | %zu | %lld | %lld | %.2f (%.2f) | %.3f |\n", name.c_str(),
        NameOf(modes[m]), FormatQuality(meshes[m]).c_str(),
        FormatCarriers(meshes[m].Report).c_str(), off.Result.PointIds.size(),
        static_cast<long long>(moved.Any), static_cast<long long>(moved.Far), seconds[m],
        SecondsOfFeatures(meshes[m].Report), seconds[m] / seconds.back());
      std::fflush(stdout);
    }
  }
}

} // namespace

int main(int argc, char** argv)
{
  try
  {
    const std::string what = argc > 1 ? argv[1] : "table";
    const bool isTable = what == "table";
    if (!isTable && what != "controls")
    {
      throw InputError("The first argument is table or controls.");
    }
    const Method method = MethodOf(argc > 2 ? argv[2] : "hexes");
    const std::vector<SharpEdgeMode> modes = ListModes(argc > 3 ? argv[3] : "Off,On,Automatic");
    const Names cases = argc > 4 ? Names(argv + 4, argv + argc) : (isTable ? TableCases : Controls);
    (isTable ? PrintTable : PrintControls)(method, modes, cases);
  }
  catch (const InputError& error)
  {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
