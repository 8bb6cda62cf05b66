#include "SharpCases.h"

#include "Base/Vector3.h"
#include "MeshChecks.h"

#include <map>

namespace vfm
{
namespace testing
{
namespace
{

constexpr double DomainWidth = 2.6;
constexpr double SampleStep = 0.1; // in cells, along edges

using Point2 = std::array<double, 2>;

/// Base of a prism: a polygon, counterclockwise, or a circle if there are no corners.
struct Figure
{
  std::vector<Point2> Corners;
  double Radius = 0.0;
  std::vector<std::vector<int>> Convex; ///< convex parts of the polygon that do not overlap
};

struct Prism
{
  Figure Base;
  double HalfHeight;
  Vector3 Centre;
  std::array<Vector3, 3> Axes;

  Vector3 PointAt(const Point2& p, double z) const
  {
    return this->Centre + p[0] * this->Axes[0] + p[1] * this->Axes[1] + z * this->Axes[2];
  }
};

double Cross2(const Point2& a, const Point2& b, const Point2& p)
{
  return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
}

/// Returns the signed distance, negative inside.
double SignedDistance(const Figure& figure, const Point2& p)
{
  if (figure.Corners.empty())
  {
    return std::hypot(p[0], p[1]) - figure.Radius;
  }
  double nearest = 1e300;
  bool isInside = false;
  for (std::size_t i = 0; i < figure.Corners.size(); ++i)
  {
    const Point2 &a = figure.Corners[i], &b = figure.Corners[(i + 1) % figure.Corners.size()];
    const Point2 along{ { b[0] - a[0], b[1] - a[1] } };
    const double t = ((p[0] - a[0]) * along[0] + (p[1] - a[1]) * along[1]) /
      (along[0] * along[0] + along[1] * along[1]);
    const double s = std::min(1.0, std::max(0.0, t));
    nearest = std::min(nearest, std::hypot(p[0] - a[0] - s * along[0], p[1] - a[1] - s * along[1]));
    const bool crosses = (a[1] > p[1]) != (b[1] > p[1]);
    isInside ^= crosses && (Cross2(a, b, p) > 0.0) == (b[1] > a[1]);
  }
  return isInside ? -nearest : nearest;
}

double DistanceToSurface(const Prism& prism, const Vector3& x)
{
  const Vector3 r = x - prism.Centre;
  const double beside =
    SignedDistance(prism.Base, { { Dot(r, prism.Axes[0]), Dot(r, prism.Axes[1]) } });
  const double above = std::fabs(Dot(r, prism.Axes[2])) - prism.HalfHeight;
  return std::fabs(std::min(std::max(beside, above), 0.0) +
    std::hypot(std::max(beside, 0.0), std::max(above, 0.0)));
}

std::vector<Shape> MakeShapes(const Prism& prism, const Vector3& rotation)
{
  if (prism.Base.Corners.empty())
  {
    return { MakeCylinder(1, prism.Centre, prism.Base.Radius, 2.0 * prism.HalfHeight, rotation) };
  }
  std::vector<Shape> shapes;
  for (const std::vector<int>& part : prism.Base.Convex)
  {
    Shape shape = MakeHalfSpace(1, prism.PointAt({ { 0, 0 } }, prism.HalfHeight), prism.Axes[2]);
    shape = CutShape(
      std::move(shape), prism.PointAt({ { 0, 0 } }, -prism.HalfHeight), -1.0 * prism.Axes[2]);
    for (std::size_t i = 0; i < part.size(); ++i)
    {
      const Point2& a = prism.Base.Corners[part[i]];
      const Point2& b = prism.Base.Corners[part[(i + 1) % part.size()]];
      const Vector3 outwards = (b[1] - a[1]) * prism.Axes[0] - (b[0] - a[0]) * prism.Axes[1];
      shape = CutShape(std::move(shape), prism.PointAt(a, 0.0), outwards);
    }
    shapes.push_back(shape);
  }
  return shapes;
}

void AddLine(const Vector3& a, const Vector3& b, std::vector<Vector3>& samples)
{
  const int steps = static_cast<int>(std::ceil(Norm(b - a) / SampleStep));
  for (int i = 0; i <= steps; ++i)
  {
    samples.push_back(a + (static_cast<double>(i) / steps) * (b - a));
  }
}

void AddEdges(const Prism& prism, SharpCase& c)
{
  const std::vector<Point2>& corners = prism.Base.Corners;
  for (double z : { -prism.HalfHeight, prism.HalfHeight })
  {
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
      const Vector3 corner = prism.PointAt(corners[i], z);
      c.Corners.push_back(corner);
      AddLine(corner, prism.PointAt(corners[(i + 1) % corners.size()], z), c.Edges);
    }
    const int steps = static_cast<int>(std::ceil(2.0 * M_PI * prism.Base.Radius / SampleStep));
    for (int i = 0; i < steps; ++i)
    {
      const double angle = 2.0 * M_PI * i / steps;
      c.Edges.push_back(prism.PointAt(
        { { prism.Base.Radius * std::cos(angle), prism.Base.Radius * std::sin(angle) } }, z));
    }
  }
  for (const Point2& corner : corners)
  {
    AddLine(
      prism.PointAt(corner, -prism.HalfHeight), prism.PointAt(corner, prism.HalfHeight), c.Edges);
  }
}

/// A solid; lengths in widths of the domain over 2.6, rotation in degrees.
struct Recipe
{
  Figure Base;
  double Height;
  Vector3 Rotation;
  bool InMatrix;
  bool OnGrid; ///< the square is in the middle, its sides on faces of cells
};

const Figure Square{ { { { -.6, -.6 } }, { { .6, -.6 } }, { { .6, .6 } }, { { -.6, .6 } } }, 0.0,
  { { 0, 1, 2, 3 } } };
// arms .6 and .55 thick
const Figure LetterL{ { { { -.6, -.6 } }, { { .6, -.6 } }, { { .6, -.05 } }, { { 0.0, -.05 } },
                        { { 0.0, .6 } }, { { -.6, .6 } } },
  0.0, { { 0, 1, 2, 3 }, { 0, 3, 4, 5 } } };
// angles of 45, 90 and 45 degrees
const Figure RightTriangle{ { { { -.45, -.45 } }, { { .85, -.45 } }, { { -.45, .85 } } }, 0.0,
  { { 0, 1, 2 } } };
const Figure Circle{ {}, .6, {} };

const std::map<std::string, Recipe>& Recipes()
{
  const double degrees = 180.0 / M_PI;
  const Vector3 turned{ { .4 * degrees, .3 * degrees, .5 * degrees } };
  static const std::map<std::string, Recipe> recipes{
    { "cube A", { Square, 1.2, turned, false, false } },
    { "cube B", { Square, 1.2, { { 45.0, 35.26, 12.0 } }, false, false } },
    { "cube C", { Square, 1.2, { { 0.0, 0.0, 0.0 } }, false, false } },
    { "cube D", { Square, 1.2, { { 0.0, 0.0, 0.0 } }, false, true } },
    { "L", { LetterL, 1.1, turned, false, false } },
    { "cylinder", { Circle, 1.3, turned, false, false } },
    { "wedge 45", { RightTriangle, 1.2, turned, false, false } },
    { "cube A in matrix", { Square, 1.2, turned, true, false } },
  };
  return recipes;
}

Figure Scaled(Figure figure, double scale)
{
  for (Point2& corner : figure.Corners)
  {
    corner = { { scale * corner[0], scale * corner[1] } };
  }
  figure.Radius *= scale;
  return figure;
}

} // namespace

std::vector<std::string> ListSharpCases()
{
  std::vector<std::string> names;
  for (const auto& recipe : Recipes())
  {
    names.push_back(recipe.first);
  }
  return names;
}

SharpCase MakeSharpCase(const std::string& name, int cells)
{
  const auto at = Recipes().find(name);
  if (at == Recipes().end() || cells < 4)
  {
    throw InputError("There is no solid with edges '" + name + "', or its cells are too few.");
  }
  const Recipe& recipe = at->second;
  const double middle = recipe.OnGrid ? cells / 2 : 0.5 * cells;
  const double scale =
    recipe.OnGrid ? std::round(.6 * cells / DomainWidth) / .6 : cells / DomainWidth;
  const double off = recipe.OnGrid ? 0.0 : scale;
  const Vector3 centre{ { middle + .013 * off, middle + .027 * off, middle - .019 * off } };
  const Prism prism{ Scaled(recipe.Base, scale), 0.5 * recipe.Height * scale, centre,
    MakeBox(1, centre, { { 1, 1, 1 } }, recipe.Rotation).Axes };
  std::vector<Shape> shapes = MakeShapes(prism, recipe.Rotation);
  if (recipe.InMatrix)
  {
    const double edge = 4.0 * cells;
    shapes.push_back(MakeBox(2, centre, { { edge, edge, edge } }));
  }
  const CartesianGrid grid = MakeUnitGrid(cells);
  SharpCase c{ name + " " + std::to_string(cells), grid, FractionsOfShapes(grid, shapes),
    [prism](const Vector3& x) { return DistanceToSurface(prism, x); }, {}, {} };
  AddEdges(prism, c);
  return c;
}

SharpFigures MeasureSharp(const SharpCase& c, const Mesh& mesh, const MeshReport& report)
{
  const MeshInterface interface(mesh);
  SharpFigures figures;
  figures.VolumeError = std::fabs(MeasureVolume(mesh, 1) / report.TargetVolume[1] - 1.0);
  figures.NodesToSurface = Measure(interface.Nodes, c.Distance);
  figures.MeshToSurface = Measure(interface.Samples, c.Distance);
  if (interface.Nodes.empty())
  {
    return figures;
  }
  std::vector<NearestTriangle::Corners> nodes;
  for (const Vector3& x : interface.Nodes)
  {
    nodes.push_back({ { x, x, x } });
  }
  const NearestTriangle nearestNode(std::move(nodes)), nearestFacet(interface.Triangles);
  const auto toNode = [&](const Vector3& x) { return nearestNode.Distance(x); };
  figures.EdgesToMesh =
    Measure(c.Edges, [&](const Vector3& x) { return nearestFacet.Distance(x); });
  figures.EdgesToNodes = Measure(c.Edges, toNode);
  figures.CornersToNodes = Measure(c.Corners, toNode);
  return figures;
}

} // namespace testing
} // namespace vfm
