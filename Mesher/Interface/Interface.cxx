#include "Interface/Interface.h"

#include "Base/Vector3.h"
#include "Interface/Crossings.h"
#include "Interface/FilmCrossings.h"

#include <numeric>

namespace vfm
{
namespace
{

// Least squared sine of the angle between interface and side of the domain.
constexpr double SmallestSlide = 0.1;
// Least distance of a node to a crossing, in cells; limits its weight.
constexpr double SmallestDistance = 0.05;
constexpr Index NodesOfBlock = 1024; // nodes per task

} // namespace

Interface::Interface(const CartesianGrid& grid, const FractionField& fractions,
  const LabelArray& labels, std::vector<Index> mixed, double isoValue, Runtime& runtime,
  const std::vector<Index>& steps, const std::vector<Index>& thin) :
  TheGrid(grid), MeanWidth(grid.MeanWidth()), MixedNodes(std::move(mixed))
{
  this->FindFaces(labels, runtime);
  this->TheCrossings.resize(this->TheFaces.size());
  const FilmCrossings films(grid, fractions, labels, thin, runtime);
  const auto isStep = [&](Index cell)
  { return std::binary_search(steps.begin(), steps.end(), cell); };
  runtime.For(0, static_cast<Index>(this->TheFaces.size()),
    [&](Index first, Index last)
    {
      CrossingFinder finder(grid, fractions, isoValue);
      for (Index f = first; f < last; ++f)
      {
        const InterfaceFace& face = this->TheFaces[f];
        if (const std::optional<Crossing> film = films.Find(face))
        {
          this->TheCrossings[f] = *film;
          continue;
        }
        this->TheCrossings[f] = isStep(face.Node) || isStep(face.Node - grid.Stride(face.Axis))
          ? finder.FindNear(face)
          : finder.Find(face);
      }
    });
  this->FindSurfacePoints(runtime);
}

Index Interface::Find(Index node) const
{
  const auto at = std::lower_bound(this->MixedNodes.begin(), this->MixedNodes.end(), node);
  return at != this->MixedNodes.end() && *at == node ? at - this->MixedNodes.begin() : -1;
}

void Interface::FindFaces(const LabelArray& labels, Runtime& runtime)
{
  const std::vector<FaceAndNodes> faces =
    CollectItems<FaceAndNodes>(runtime, this->MixedNodes.size(), NodesOfBlock,
      [&](Index n, std::vector<FaceAndNodes>& found)
      {
        ForFacesOfNode(this->TheGrid, labels, this->MixedNodes[n], this->TheGrid.Local(),
          [&](const InterfaceFace& face, const Index3&, const Index3&)
          { this->AddFace(face, found); });
      });
  this->TheFaces.resize(faces.size());
  this->FaceNodes.resize(faces.size());
  ForEach(runtime, faces.size(),
    [&](Index f)
    {
      this->TheFaces[f] = faces[f].first;
      this->FaceNodes[f] = faces[f].second;
    });
  this->FacesOfNodes = MakeGroups<int>(this->MixedNodes.size(),
    [this](const auto& visit)
    {
      for (std::size_t f = 0; f < this->FaceNodes.size(); ++f)
      {
        for (Index n : this->FaceNodes[f])
        {
          visit(n, static_cast<int>(f));
        }
      }
    });
}

/// Adds a face and its nodes, unless one of them is not listed.
void Interface::AddFace(const InterfaceFace& face, std::vector<FaceAndNodes>& faces) const
{
  std::array<int, 4> corners;
  const std::array<Index, 4> nodes = NodesOfFace(this->TheGrid, face);
  std::transform(nodes.begin(), nodes.end(), corners.begin(),
    [this](Index node) { return static_cast<int>(this->Find(node)); });
  if (std::find(corners.begin(), corners.end(), -1) == corners.end())
  {
    faces.push_back({ face, corners });
  }
}

Vector3 Interface::NodePoint(Index node) const
{
  const Index3 p = this->TheGrid.Position(node);
  Vector3 x = this->TheGrid.NodePoint(p);
  for (int a = 0; a < 3; ++a)
  {
    x[a] = (x[a] - this->TheGrid.Coordinates(a)[0]) / this->MeanWidth;
  }
  return x;
}

Vector3 Interface::NodeWidths(Index node) const
{
  const Index3 p = this->TheGrid.Position(node);
  Vector3 widths;
  for (int a = 0; a < 3; ++a)
  {
    const Index low = std::max<Index>(p[a] - 1, 0);
    const Index high = std::min(p[a], this->TheGrid.Global().Upper[a] - 1);
    widths[a] =
      0.5 * (this->TheGrid.Width(a, low) + this->TheGrid.Width(a, high)) / this->MeanWidth;
  }
  return widths;
}

void Interface::FindSurfacePoints(Runtime& runtime)
{
  const Index count = static_cast<Index>(this->MixedNodes.size());
  std::vector<std::vector<SurfacePoint>> found((count + NodesOfBlock - 1) / NodesOfBlock);
  this->PointsAt.assign(count + 1, 0);
  ForEach(runtime, found.size(),
    [&](Index block)
    {
      std::vector<SurfacePoint> points;
      const Index first = block * NodesOfBlock;
      for (Index n = first; n < std::min(count, first + NodesOfBlock); ++n)
      {
        points.clear();
        this->AddSurfacePoints(n, points);
        this->PointsAt[n + 1] = static_cast<Index>(points.size());
        found[block].insert(found[block].end(), points.begin(), points.end());
      }
    });
  std::partial_sum(this->PointsAt.begin(), this->PointsAt.end(), this->PointsAt.begin());
  this->SurfacePoints = Joined(found);
}

/// Adds a point per pair at the node: the mean of the node projected onto the planes of the
/// crossings of the pair around it, with weights 1 / distance^2.
void Interface::AddSurfacePoints(Index n, std::vector<SurfacePoint>& points) const
{
  const Index node = this->MixedNodes[n];
  const Vector3 x = this->NodePoint(node), widths = this->NodeWidths(node);
  std::vector<double> weights;
  for (Index at = this->FaceOffset(n); at < this->FaceOffset(n + 1); ++at)
  {
    const Index f = this->FaceList()[at];
    const int a = this->TheFaces[f].First(), b = this->TheFaces[f].Second();
    std::size_t slot = 0;
    while (slot < points.size() &&
      (points[slot].First < a || (points[slot].First == a && points[slot].Second < b)))
    {
      ++slot;
    }
    if (slot == points.size() || points[slot].First != a || points[slot].Second != b)
    {
      points.insert(points.begin() + slot, { a, b, { { 0.0, 0.0, 0.0 } }, { { 0.0, 0.0, 0.0 } } });
      weights.insert(weights.begin() + slot, 0.0);
    }
    const Crossing& crossing = this->TheCrossings[f];
    const Vector3 away = x - crossing.Point;
    const double distance = std::max(Norm(Divided(away, widths)), SmallestDistance);
    const double w = 1.0 / (distance * distance);
    points[slot].Point =
      points[slot].Point + w * (x - Dot(away, crossing.Normal) * crossing.Normal);
    points[slot].Normal = points[slot].Normal + w * crossing.Normal;
    weights[slot] += w;
  }
  for (std::size_t slot = 0; slot < points.size(); ++slot)
  {
    points[slot].Point = (1.0 / weights[slot]) * points[slot].Point;
    points[slot].Normal = Unit(points[slot].Normal);
    this->SlideIntoDomain(node, x, points[slot]);
  }
}

/// Moves a point at a side of the domain along its tangent plane to the nearest place on that side.
void Interface::SlideIntoDomain(Index node, const Vector3& x, SurfacePoint& point) const
{
  const int sides = this->TheGrid.DomainSides(this->TheGrid.Position(node));
  Vector3 along = point.Normal;
  for (int a = 0; a < 3; ++a)
  {
    along[a] = sides >> (2 * a) & 3 ? 0.0 : along[a];
  }
  const double slope = Dot(along, along);
  if (sides != 0 && slope > SmallestSlide)
  {
    point.Point = x - (Dot(x - point.Point, point.Normal) / slope) * along;
  }
}

const SurfacePoint* Interface::FindPoint(Index n, int first, int second) const
{
  for (Index p = this->PointsAt[n]; p < this->PointsAt[n + 1]; ++p)
  {
    const SurfacePoint& point = this->SurfacePoints[p];
    if (point.First == first && point.Second == second)
    {
      return &point;
    }
  }
  return nullptr;
}

} // namespace vfm
