#include "GivenSurfaces/FollowSurfaces.h"

#include "GivenSurfaces/EdgeModels.h"
#include "SharpFeatures/FeatureSites.h"

namespace vfm
{
namespace
{

constexpr FitRange SmoothRange{ 1.5, 0.7 };
constexpr double NearFoot = 0.6, FarFoot = 1.8; // distances of the surface from a surface point
constexpr double FootCosine = 0.2;              // between the interface and the surface
constexpr double TurnedCost = 0.3; // of a foot whose normal differs by a right angle, in cells

/// Search at a surface point. Normals point to the second label.
class PointSearch
{
public:
  PointSearch(const NearSurface& surface, bool isSecondInside, const NodeFrame& frame,
    const SurfacePoint& point) :
    Surface(surface),
    Sign(isSecondInside ? -1.0 : 1.0),
    Frame(frame),
    Start(Divided(point.Point - frame.Origin, frame.Widths)),
    Normal(Unit(Scaled(point.Normal, frame.Widths)))
  {
  }

  /// Returns the quadric of the surface where it is nearest to the point.
  std::optional<SampleFit> FitSmooth()
  {
    const NearSample* foot = this->FindFoot(NearFoot);
    foot = foot ? foot : this->FindFoot(FarFoot);
    if (!foot)
    {
      return std::nullopt;
    }
    return FitSamples(
      this->Around.Samples, { foot->At, foot->Normal, SurfacePart::AnySheet, {} }, SmoothRange);
  }

  /// Returns the model of the edge nearest to the node.
  std::optional<EdgeModel> FitEdges()
  {
    if (!this->FindEdges())
    {
      return std::nullopt;
    }
    this->List(EdgeReach + 2.0);
    this->Surface.ListCorners(this->Frame, CornerReach, this->Around.Corners);
    for (NearCorner& corner : this->Around.Corners)
    {
      for (Vector3& normal : corner.Normals)
      {
        normal = this->Sign * normal;
      }
    }
    return MakeEdgeModel(this->Around, this->Normal);
  }

private:
  /// Collects the edges near the node; returns whether there are some.
  bool FindEdges()
  {
    this->Surface.ListEdges(this->Frame, EdgeReach, this->Around.Edges);
    for (NearEdge& edge : this->Around.Edges)
    {
      edge.Normals = { this->Sign * edge.Normals[0], this->Sign * edge.Normals[1] };
      edge.IsConvex = edge.IsConvex == (this->Sign < 0.0);
    }
    return !this->Around.Edges.empty();
  }

  /// Collects the samples within a radius of the node.
  void List(double radius)
  {
    this->Surface.ListSamples(this->Frame, radius, this->Around.Samples);
    for (NearSample& sample : this->Around.Samples)
    {
      sample.Normal = this->Sign * sample.Normal;
    }
  }

  /// Collects the samples that a fit around a foot needs, and returns the nearest sample within a
  /// distance that faces like the interface, or null.
  const NearSample* FindFoot(double farthest)
  {
    this->List(Norm(this->Start) + farthest + SmoothRange.Radius);
    const NearSample* foot = nullptr;
    double least = 1e30;
    for (const NearSample& sample : this->Around.Samples)
    {
      const double cosine = Dot(sample.Normal, this->Normal);
      const double distance = Norm(sample.At - this->Start);
      const double cost = distance + TurnedCost * (1.0 - cosine);
      if (distance <= farthest && cosine > FootCosine && cost < least)
      {
        least = cost;
        foot = &sample;
      }
    }
    return foot;
  }

  const NearSurface& Surface;
  double Sign; // of normals towards the second label
  const NodeFrame& Frame;
  Vector3 Start, Normal; // of the surface point, in the local frame
  NodeSurroundings Around;
};

/// A surface point of a level with a surface.
struct GivenPoint
{
  Index Node, Point; ///< positions in Interface::Nodes() and Points()
  int Body;          ///< position in BodySurfaces::Bodies()
  bool IsSecondInside;
};

/// Lists the points of owned nodes and of nodes within two of them.
std::vector<GivenPoint> ListPoints(const BodySurfaces& bodies, const Interface& interface)
{
  const CartesianGrid& grid = interface.Grid();
  const IndexBox nodes = NodesOf(Grow(grid.Owned(), FeatureSites::Spread, grid.Global()));
  std::vector<GivenPoint> points;
  for (Index n = 0; n < static_cast<Index>(interface.Nodes().size()); ++n)
  {
    const bool isNear = nodes.Contains(grid.Position(interface.Nodes()[n]));
    for (Index p = interface.PointOffset(n); isNear && p < interface.PointOffset(n + 1); ++p)
    {
      const SurfacePoint& point = interface.Points()[p];
      const int body = bodies.FindOfInterface(point.First, point.Second);
      if (body >= 0)
      {
        points.push_back({ n, p, body, bodies.Bodies()[body].Material == point.Second });
      }
    }
  }
  return points;
}

/// Interface of one level and its targets.
struct FollowedLevel
{
  const Interface& Source;
  Index FirstTarget; ///< target of the first surface point
  double Ratio;      ///< factor from its grid coordinates to those of the finest grid
};

/// Replaces the targets of the points of a level. Returns the models of edges.
std::vector<std::optional<EdgeModel>> FollowPoints(const std::vector<GivenPoint>& points,
  const std::vector<NearSurface>& surfaces, const FollowedLevel& level, bool hasEdges,
  Runtime& runtime, SurfaceTargets& targets)
{
  std::vector<std::optional<EdgeModel>> models(points.size());
  ForEach(runtime, points.size(),
    [&](Index i)
    {
      const GivenPoint& at = points[i];
      const NodeFrame frame = FrameOf(level.Source, at.Node);
      PointSearch search(
        surfaces[at.Body], at.IsSecondInside, frame, level.Source.Points()[at.Point]);
      if (const std::optional<SampleFit> fit = search.FitSmooth())
      {
        targets.Replace(level.FirstTarget + at.Point, fit->Surface, level.Ratio * frame.Origin,
          level.Ratio * frame.Widths);
      }
      models[i] = hasEdges ? search.FitEdges() : std::nullopt;
    });
  return models;
}

} // namespace

SharpFeatures FollowSurfaces(const BodySurfaces& bodies,
  const std::vector<const Interface*>& interfaces, bool hasEdges, Runtime& runtime,
  SurfaceTargets& targets)
{
  std::vector<Index> found;
  std::vector<NodeFeature> features;
  Index first = 0;
  for (const Interface* interface : interfaces)
  {
    const FollowedLevel level{ *interface, first, interface->Scale() / interfaces.back()->Scale() };
    std::vector<NearSurface> surfaces;
    for (std::size_t body = 0; body < bodies.Bodies().size(); ++body)
    {
      surfaces.emplace_back(bodies, static_cast<int>(body), level.Ratio, *interface);
    }
    const std::vector<GivenPoint> points = ListPoints(bodies, *interface);
    const auto models = FollowPoints(points, surfaces, level, hasEdges, runtime, targets);
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      if (models[i])
      {
        const NodeFrame frame = FrameOf(*interface, points[i].Node);
        found.push_back(first + points[i].Point);
        features.push_back({ models[i]->Model, level.Ratio * frame.Origin,
          level.Ratio * frame.Widths, models[i]->Fades });
      }
    }
    first += static_cast<Index>(interface->Points().size());
  }
  return SharpFeatures(std::move(found), std::move(features));
}

} // namespace vfm
