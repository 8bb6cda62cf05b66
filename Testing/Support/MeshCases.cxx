#include "MeshCases.h"

#include "Smoothing/ActiveMesh.h"

#include "Base/Vector3.h"
#include "RandomDraw.h"
#include "Shapes/ShapesScenes.h"

#include <chrono>
#include <cstdio>
#include <map>
#include <set>

namespace vfm
{
namespace testing
{
namespace
{

struct Floors
{
  double MinimumJacobian, MeanJacobian, LargestDistance, RmsDistance, VolumeError;
};

using PairDistance = std::function<double(int, int, const Vector3&)>;

MeshCase MakeCase(const std::string& name, const CartesianGrid& grid,
  const std::vector<Shape>& shapes, const PairDistance& distance, const Floors& f)
{
  return { name, grid, FractionsOfShapes(grid, shapes), distance, f.MinimumJacobian, f.MeanJacobian,
    f.LargestDistance, f.RmsDistance, f.VolumeError };
}

/// Returns the distance to the union of the shapes, for cases with one material.
PairDistance DistanceToUnion(const std::vector<Shape>& shapes)
{
  return [shapes](int, int, const Vector3& x)
  {
    double nearest = 1e300;
    for (const Shape& shape : shapes)
    {
      nearest = std::min(nearest, SignedDistance(shape, x));
    }
    return nearest;
  };
}

MeshCase MakeSingle(const std::string& name, const CartesianGrid& grid,
  const std::vector<Shape>& shapes, const Floors& floors)
{
  return MakeCase(name, grid, shapes, DistanceToUnion(shapes), floors);
}

Shape MakePlate(const Vector3& centre, const Vector3& normal, double thickness)
{
  const Vector3 half = 0.5 * thickness * Unit(normal);
  return CutShape(MakeHalfSpace(1, centre + half, normal), centre - half, -1.0 * normal);
}

MeshCase MakeTwoSpheres()
{
  const Vector3 centre{ { 20.1, 12.2, 12.3 } };
  const Vector3 axis = Unit({ { 1.0, 0.2, 0.1 } });
  const double radius = 9.0, reach = radius + 0.15; // a gap of 0.3
  return MakeSingle("two spheres, gap .3", MakeUnitGrid(40, 24, 24),
    { MakeSphere(1, centre - reach * axis, radius), MakeSphere(1, centre + reach * axis, radius) },
    { .625, .884, .430, .025, 1e-5 });
}

MeshCase MakeBallAndPlate()
{
  const Shape ball = MakeSphere(1, { { 20.2, 19.7, 15.6 } }, 10.0);
  const Shape plate = MakeBox(2, { { 20.0, 20.0, 5.1 } }, { { 80.0, 80.0, 6.0 } });
  const auto distance = [ball, plate](int a, int, const Vector3& x)
  {
    // The ball precedes the plate: it keeps their intersection.
    return a == 0 ? std::min(SignedDistance(ball, x), SignedDistance(plate, x))
                  : SignedDistance(ball, x);
  };
  return MakeCase("ball and plate", MakeUnitGrid(40), { ball, plate }, distance,
    { .570, .950, .160, .0120, 1e-5 });
}

MeshCase MakeSectors()
{
  const Vector3 centre{ { 12.1, 11.9, 12.2 } };
  const Shape ball = MakeSphere(1, centre, 9.6);
  // Three half-planes from the axis along z, 120 degrees apart; normals[s] points
  // against the sense of rotation.
  std::array<Vector3, 3> normals;
  for (int s = 0; s < 3; ++s)
  {
    const double angle = 0.3 + 2.0 * M_PI / 3.0 * s;
    normals[s] = { { std::sin(angle), -std::cos(angle), 0.0 } };
  }
  std::vector<Shape> sectors;
  for (int s = 0; s < 3; ++s)
  {
    sectors.push_back(
      CutShape(CutShape(ball, centre, normals[s]), centre, -1.0 * normals[(s + 1) % 3]));
    sectors.back().Material = s + 1;
  }
  const auto distance = [=](int a, int b, const Vector3& x)
  {
    const int plane = a == 1 && b == 3 ? 0 : b - 1; // between sectors a and b
    return a == 0 ? SignedDistance(ball, x) : Dot(x - centre, normals[plane]);
  };
  return MakeCase(
    "ball of 3 sectors", MakeUnitGrid(24), sectors, distance, { .515, .819, .214, .024, 1e-5 });
}

const std::map<std::string, std::function<MeshCase()>>& Cases()
{
  const Vector3 middle{ { 12.1, 12.2, 12.3 } };
  static const std::map<std::string, std::function<MeshCase()>> cases{
    { "sphere 8", [] { return MakeSphereCase(8); } },
    { "sphere 16", [] { return MakeSphereCase(16); } },
    { "sphere 32", [] { return MakeSphereCase(32); } },
    { "sphere 64", [] { return MakeSphereCase(64); } },
    { "two spheres, gap .3", MakeTwoSpheres },
    { "plate 2 thick",
      [=]
      {
        return MakeSingle("plate 2 thick", MakeUnitGrid(24),
          { MakePlate(middle, { { 1, 2, 3 } }, 2.0) }, { .595, .760, .205, .012, 1e-5 });
      } },
    { "plate 5 thick",
      [=]
      {
        return MakeSingle("plate 5 thick", MakeUnitGrid(24),
          { MakePlate(middle, { { 1, 2, 3 } }, 5.0) }, { .565, .831, .227, .012, 1e-5 });
      } },
    { "torus",
      []
      {
        return MakeSingle("torus", MakeUnitGrid(40, 40, 16),
          { MakeTorus(1, { { 20.1, 20.2, 8.3 } }, 12.0, 4.8) }, { .693, .863, .038, .017, 1e-5 });
      } },
    { "gyroid",
      []
      {
        return MakeSingle("gyroid", MakeUnitGrid(32),
          { MakeGyroid(1, { { 0.1, 0.2, 0.3 } }, 16.0) }, { .552, .837, .284, .023, 1e-5 });
      } },
    { "cut cylinder",
      [=]
      {
        return MakeSingle("cut cylinder", MakeUnitGrid(24),
          { MakeCylinder(1, middle, 7.5, 60.0, { { 6, 4, 0 } }) },
          { .710, .925, .025, .0100, 1e-5 });
      } },
    { "half sphere",
      []
      {
        return MakeSingle("half sphere", MakeUnitGrid(24, 24, 12),
          { MakeSphere(1, { { 12.1, 12.2, 0.0 } }, 8.3) }, { .720, .890, .030, .0165, 1e-5 });
      } },
    { "ball and plate", MakeBallAndPlate },
    { "ball of 3 sectors", MakeSectors },
    { "polycrystal", [] { return MakePolycrystalCase(30, 24); } },
  };
  return cases;
}

/// Returns the points whose interface facets have one pair of materials only, with that pair.
std::map<Index, std::pair<int, int>> FindPlainPoints(const Mesh& mesh)
{
  const int corners = mesh.CornersOfFacet();
  std::map<Index, std::pair<int, int>> pairs;
  std::set<Index> junctions;
  for (std::size_t f = 0; f < mesh.Surfaces.DomainSide.size(); ++f)
  {
    const std::pair<int, int> pair(
      mesh.Surfaces.MaterialPair[2 * f], mesh.Surfaces.MaterialPair[2 * f + 1]);
    for (int c = 0; mesh.Surfaces.DomainSide[f] < 0 && c < corners; ++c)
    {
      const auto at = pairs.emplace(mesh.Surfaces.Points[corners * f + c], pair);
      if (at.first->second != pair)
      {
        junctions.insert(at.first->first);
      }
    }
  }
  for (Index point : junctions)
  {
    pairs.erase(point);
  }
  return pairs;
}

} // namespace

std::vector<std::string> ListMeshCases()
{
  std::vector<std::string> names;
  for (const auto& entry : Cases())
  {
    names.push_back(entry.first);
  }
  return names;
}

MeshCase MakeMeshCase(const std::string& name)
{
  return Cases().at(name)();
}

MeshCase MakeSphereCase(int diameter)
{
  static const std::map<int, Floors> floors{ { 8, { .698, .832, .078, .037, 1e-5 } },
    { 16, { .708, .879, .046, .018, 1e-5 } }, { 32, { .730, .918, .037, .010, 1e-5 } },
    { 64, { .708, .948, .035, .0055, 1e-5 } } };
  const int cells = diameter + 6;
  const double middle = 0.5 * cells;
  const auto at = floors.find(diameter);
  return MakeSingle("sphere " + std::to_string(diameter), MakeUnitGrid(cells),
    { MakeSphere(1, { { middle + 0.1, middle + 0.2, middle + 0.3 } }, 0.5 * diameter) },
    at == floors.end() ? Floors{ .7, .8, .1, .04, 1e-5 } : at->second);
}

MeshCase MakePolycrystalCase(int grains, int n, unsigned seed)
{
  RandomDraw draw(seed);
  auto seeds = std::make_shared<std::vector<Vector3>>();
  for (int g = 0; g < grains; ++g)
  {
    seeds->push_back(draw.Vector(0.0, n));
  }
  std::vector<Shape> shapes;
  for (int g = 0; g < grains; ++g)
  {
    shapes.push_back(MakeVoronoiCell(g + 1, seeds, g));
  }
  const auto distance = [seeds](int a, int b, const Vector3& x)
  {
    const Vector3 &p = (*seeds)[a - 1], &q = (*seeds)[b - 1];
    return Dot(x - 0.5 * (p + q), Unit(q - p));
  };
  return MakeCase(
    "polycrystal", MakeUnitGrid(n), shapes, distance, { .461, .803, .433, .0285, 1e-5 });
}

MeshCase MakeEightShapesCase(int n)
{
  const double size = n;
  const std::vector<Shape> shapes =
    MakeScene(Scene::EightShapes, { { 0.0, 0.0, 0.0 } }, { { size, size, size } });
  const auto distance = [shapes](int a, int b, const Vector3& x)
  {
    // Each material is one shape; where two touch, the interface lies on the surface of either.
    const double second = std::fabs(SignedDistance(shapes[b - 1], x));
    return a == 0 ? second : std::min(second, std::fabs(SignedDistance(shapes[a - 1], x)));
  };
  return MakeCase("eight shapes", MakeUnitGrid(n), shapes, distance, { .4, .8, 1.0, .1, 1e-5 });
}

namespace
{

Distances Summarise(const std::vector<double>& values)
{
  Distances d;
  double sum = 0.0;
  for (double value : values)
  {
    d.Largest = std::max(d.Largest, value);
    sum += value * value;
  }
  d.RootMeanSquare = std::sqrt(sum / std::max<std::size_t>(values.size(), 1));
  return d;
}

} // namespace

FractionField MakeConcentricLabels(const CartesianGrid& grid, Index n)
{
  const double cm = static_cast<double>(n) / 26.0;
  return MakeLabels(grid, 4,
    [=](const Index3& p)
    {
      double r2 = 0.0;
      for (int a = 0; a < 3; ++a)
      {
        const double x = p[a] + 0.5 - 0.5 * n;
        r2 += x * x / (cm * cm);
      }
      return r2 < 100.0 ? 1 : (r2 < 121.0 ? 2 : (r2 < 144.0 ? 3 : 4));
    });
}

void MeasureInterfaces(const MeshCase& c, const Mesh& mesh, Distances& distance, Distances& onSides)
{
  std::vector<double> distances, sides;
  for (const auto& point : FindPlainPoints(mesh))
  {
    const double* x = mesh.Points.data() + 3 * point.first;
    distances.push_back(
      std::fabs(c.Distance(point.second.first, point.second.second, { { x[0], x[1], x[2] } })));
    if (FindDomainSides(c.Grid, x) != 0)
    {
      sides.push_back(distances.back());
    }
  }
  distance = Summarise(distances);
  onSides = Summarise(sides);
}

MeshFigures MeasureCase(
  const MeshCase& c, const MeshOptions& options, Runtime& runtime, MeshMaker make)
{
  MeshFigures figures;
  const auto begin = std::chrono::steady_clock::now();
  figures.Result = make(c.Grid, c.Fractions, options, runtime, figures.Report);
  figures.Seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  const Mesh& mesh = figures.Result;
  figures.Elements = mesh.ElementIds.size();
  figures.Points = mesh.PointIds.size();
  MeasureInterfaces(c, mesh, figures.Distance, figures.OnSides);
  for (std::size_t m = 1; m < figures.Report.TargetVolume.size(); ++m)
  {
    figures.VolumeError = std::max(figures.VolumeError,
      std::fabs(MeasureVolume(mesh, static_cast<int>(m)) / figures.Report.TargetVolume[m] - 1.0));
  }
  return figures;
}

std::string FormatHeader()
{
  return "| case | hexes | flips | min SJ | mean SJ | distance max/rms [cells] | volume % | "
         "hexes/s |\n"
         "|---|---|---|---|---|---|---|---|\n";
}

std::string FormatFigures(const std::string& name, const MeshFigures& f)
{
  char row[256];
  std::snprintf(row, sizeof(row), "| %s | %zu | %lld | %.3f | %.3f | %.3f/%.4f | %.5f | %.0f |\n",
    name.c_str(), f.Elements, static_cast<long long>(f.Report.FlippedCells),
    f.Report.MinimumScaledJacobian, f.Report.MeanScaledJacobian, f.Distance.Largest,
    f.Distance.RootMeanSquare, 100.0 * f.VolumeError, f.Elements / f.Seconds);
  return row;
}

std::string NameOf(TetMethod method)
{
  return method == TetMethod::TetGen ? "TetGen"
                                     : (method == TetMethod::Cells ? "Cells" : "Lattice");
}

std::string FormatTetHeader()
{
  return "| method | case | tets | dihedral | min SJ | mean SJ | distance max/rms [cells] | "
         "volume % | tets/s |\n"
         "|---|---|---|---|---|---|---|---|---|\n";
}

std::string FormatTetFigures(TetMethod method, const std::string& name, const MeshFigures& f)
{
  char row[256];
  std::snprintf(row, sizeof(row),
    "| %s | %s | %zu | %.1f - %.1f | %.3f | %.3f | %.3f/%.4f | %.5f | %.0f |\n",
    NameOf(method).c_str(), name.c_str(), f.Elements, f.Report.MinimumDihedralAngle,
    f.Report.MaximumDihedralAngle, f.Report.MinimumScaledJacobian, f.Report.MeanScaledJacobian,
    f.Distance.Largest, f.Distance.RootMeanSquare, 100.0 * f.VolumeError, f.Elements / f.Seconds);
  return row;
}

std::string FormatAnglesHeader()
{
  std::string header = "| method | case |", line = "|---|---|";
  for (int bin = 0; bin < 18; ++bin)
  {
    header += " " + std::to_string(10 * bin) + " |";
    line += "---|";
  }
  return header + "\n" + line + "\n";
}

std::string FormatAngles(TetMethod method, const std::string& name, const MeshReport& report)
{
  std::string row = "| " + NameOf(method) + " | " + name + " |";
  for (Index count : report.DihedralAngles)
  {
    row += " " + std::to_string(count) + " |";
  }
  return row + "\n";
}

} // namespace testing
} // namespace vfm
