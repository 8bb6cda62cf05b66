#include "Parts/PartFigures.h"

#include <map>
#include <numeric>

namespace vfm
{
namespace testing
{
namespace
{

constexpr double SampleStep = 0.1;   // in cells, along edges
constexpr double LargestPiece = 1.0; // edge length, in cells
constexpr double Near = 0.25;        // in cells, of edges that a mesh follows
constexpr double NormalWeight = 0.5; // of 1 - cosine, against distances in cells

using Corners = NearestTriangle::Corners;

Vector3 AreaVector(const Corners& t)
{
  return 0.5 * Cross(t[1] - t[0], t[2] - t[0]);
}

/// Calls visit(part) for the parts of a triangle that is halved until its edges are short.
template <class Visit>
void ForPieces(const Corners& t, const Visit& visit)
{
  int longest = 0;
  std::array<double, 3> lengths;
  for (int c = 0; c < 3; ++c)
  {
    lengths[c] = Norm(t[(c + 1) % 3] - t[c]);
    longest = lengths[c] > lengths[longest] ? c : longest;
  }
  if (lengths[longest] <= LargestPiece)
  {
    visit(t);
    return;
  }
  const Vector3 &a = t[longest], &b = t[(longest + 1) % 3], &c = t[(longest + 2) % 3];
  const Vector3 middle = 0.5 * (a + b);
  ForPieces({ { a, middle, c } }, visit);
  ForPieces({ { middle, b, c } }, visit);
}

/// Connected groups of numbers.
class Union
{
public:
  explicit Union(std::size_t count) : Parents(count)
  {
    std::iota(this->Parents.begin(), this->Parents.end(), 0);
  }
  int Find(int item)
  {
    while (this->Parents[item] != item)
    {
      item = this->Parents[item] = this->Parents[this->Parents[item]];
    }
    return item;
  }
  void Join(int a, int b) { this->Parents[this->Find(a)] = this->Find(b); }

private:
  std::vector<int> Parents;
};

/// Returns the triangles around each edge of a body.
std::map<std::array<Index, 2>, std::vector<int>> FindEdges(const ClosedSurface& surface)
{
  std::map<std::array<Index, 2>, std::vector<int>> edges;
  for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
  {
    for (int c = 0; c < 3; ++c)
    {
      const Index a = surface.Triangles[t][c], b = surface.Triangles[t][(c + 1) % 3];
      edges[{ { std::min(a, b), std::max(a, b) } }].push_back(static_cast<int>(t));
    }
  }
  return edges;
}

void AppendSamples(const Vector3& a, const Vector3& b, std::vector<Vector3>& samples)
{
  const int count = std::max(1, static_cast<int>(std::round(Norm(b - a) / SampleStep)));
  for (int i = 0; i < count; ++i)
  {
    samples.push_back(a + ((i + 0.5) / count) * (b - a));
  }
}

/// Sides of the triangles of a body, from 0, and samples of its sharp edges.
struct BodySides
{
  std::vector<int> OfTriangle;
  int Count = 0;
};
BodySides FindSides(const BodySurface& body, double angle, std::vector<Vector3>& edgeSamples)
{
  const std::vector<Triangle> triangles = PlaceTriangles(body.Boundary);
  const double cosine = std::cos(angle * std::acos(-1.0) / 180.0);
  Union joined(triangles.size());
  for (const auto& [ends, around] : FindEdges(body.Boundary))
  {
    const Vector3 normal = Unit(AreaVector(triangles[around[0]]));
    const bool isSharp =
      around.size() != 2 || Dot(normal, Unit(AreaVector(triangles[around[1]]))) < cosine;
    if (isSharp)
    {
      AppendSamples(body.Boundary.Points[ends[0]], body.Boundary.Points[ends[1]], edgeSamples);
    }
    else if (body.Patches.empty() || body.Patches[around[0]] == body.Patches[around[1]])
    {
      joined.Join(around[0], around[1]);
    }
  }
  BodySides sides;
  std::map<int, int> numbers;
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    sides.OfTriangle.push_back(
      numbers.emplace(joined.Find(static_cast<int>(t)), static_cast<int>(numbers.size()))
        .first->second);
  }
  sides.Count = static_cast<int>(numbers.size());
  return sides;
}

/// Area that a surface of the mesh and a side of the part have in common.
using SharedAreas = std::map<std::array<int, 2>, double>;

/// Returns the surface of the mesh that shares most area with each side, and the reverse (place 1).
std::array<std::map<int, int>, 2> FindPartners(const SharedAreas& shared)
{
  std::array<std::map<int, int>, 2> partners;
  std::array<std::map<int, double>, 2> most;
  for (const auto& [pair, area] : shared)
  {
    for (int p = 0; p < 2; ++p)
    {
      double& largest = most[p][pair[1 - p]];
      if (area > largest)
      {
        largest = area;
        partners[p][pair[1 - p]] = pair[p];
      }
    }
  }
  return partners;
}

void MeasureSides(
  const TrueSurface& part, const Mesh& mesh, const MeshInterface& interface, PartFigures& figures)
{
  SharedAreas shared;
  std::map<int, double> areas; // of surfaces of the mesh
  for (std::size_t t = 0; t < interface.Triangles.size(); ++t)
  {
    const Corners& x = interface.Triangles[t];
    const Vector3 area = AreaVector(x);
    const int surface = mesh.Surfaces.SurfaceId[interface.Facets[t]];
    const int side = part.FindSide(1.0 / 3.0 * (x[0] + x[1] + x[2]), Unit(area));
    shared[{ { surface, side } }] += Norm(area);
    areas[surface] += Norm(area);
  }
  const auto [surfaceOf, sideOf] = FindPartners(shared);
  figures.Sides = static_cast<Index>(part.SideAreas().size());
  figures.MeshSurfaces = static_cast<Index>(areas.size());
  for (Index s = 0; s < figures.Sides; ++s)
  {
    double error = 1.0;
    const auto surface = surfaceOf.find(static_cast<int>(s));
    if (surface != surfaceOf.end() && sideOf.at(surface->second) == s)
    {
      ++figures.SidesFound;
      error = std::fabs(areas[surface->second] / part.SideAreas()[s] - 1.0);
    }
    figures.WorstSideArea = std::max(figures.WorstSideArea, error);
    figures.MeanSideArea += error / static_cast<double>(figures.Sides);
  }
}

} // namespace

TrueSurface TrueSurface::Make(const InputSurfaces& surfaces, double angle)
{
  Pieces pieces;
  std::vector<double> areas;
  std::vector<Vector3> edges;
  for (const BodySurface& body : surfaces.Bodies)
  {
    const BodySides sides = FindSides(body, angle, edges);
    const int first = static_cast<int>(areas.size());
    areas.resize(first + sides.Count, 0.0);
    const std::vector<Triangle> triangles = PlaceTriangles(body.Boundary);
    for (std::size_t t = 0; t < triangles.size(); ++t)
    {
      const int side = first + sides.OfTriangle[t];
      areas[side] += Norm(AreaVector(triangles[t]));
      ForPieces(triangles[t],
        [&](const Corners& piece)
        {
          pieces.Triangles.push_back(piece);
          pieces.Sides.push_back(side);
        });
    }
  }
  return TrueSurface(std::move(pieces), std::move(areas), std::move(edges));
}

TrueSurface::TrueSurface(const InputSurfaces& surfaces, double angle) :
  TrueSurface(Make(surfaces, angle))
{
}

TrueSurface::TrueSurface(Pieces pieces, std::vector<double> areas, std::vector<Vector3> edges) :
  Sides(std::move(pieces.Sides)),
  Nearest(pieces.Triangles),
  Areas(std::move(areas)),
  Edges(std::move(edges))
{
  for (const Corners& x : pieces.Triangles)
  {
    this->Normals.push_back(Unit(AreaVector(x)));
    this->Inner.insert(this->Inner.end(), x.begin(), x.end());
    this->Inner.push_back(1.0 / 3.0 * (x[0] + x[1] + x[2]));
  }
}

int TrueSurface::FindSide(const Vector3& x, const Vector3& normal) const
{
  const int nearest = this->Nearest.Find(x,
    [&](int piece, double distance)
    { return distance + NormalWeight * (1.0 - Dot(normal, this->Normals[piece])); });
  return this->Sides[nearest];
}

PartFigures MeasurePart(const TrueSurface& part, const Mesh& mesh, const MeshReport& report)
{
  PartFigures figures;
  for (std::size_t m = 1; m < report.TargetVolume.size(); ++m)
  {
    figures.VolumeError =
      std::max(figures.VolumeError, std::fabs(report.MeshVolume[m] / report.TargetVolume[m] - 1.0));
  }
  const MeshInterface interface(mesh);
  if (interface.Triangles.empty())
  {
    return figures;
  }
  const auto toPart = [&](const Vector3& x) { return part.Distance(x); };
  const NearestTriangle facets(interface.Triangles);
  const auto toMesh = [&](const Vector3& x) { return facets.Distance(x); };
  figures.Nodes = Measure(interface.Nodes, toPart);
  const SharpDistances there = Measure(interface.Samples, toPart);
  const SharpDistances back = Measure(part.Samples(), toMesh);
  figures.Hausdorff = std::max(there.Largest, back.Largest);
  figures.RmsDistance = std::max(there.RootMeanSquare, back.RootMeanSquare);
  std::vector<double> edges;
  for (const Vector3& x : part.EdgeSamples())
  {
    edges.push_back(toMesh(x));
  }
  if (!edges.empty())
  {
    figures.EdgesNear = static_cast<double>(std::count_if(edges.begin(), edges.end(),
                          [](double distance) { return distance <= Near; })) /
      static_cast<double>(edges.size());
  }
  figures.Edges = Summarise(std::move(edges));
  MeasureSides(part, mesh, interface, figures);
  return figures;
}

} // namespace testing
} // namespace vfm
