#include "GivenSurfaces/FollowSurfaces.h"

#include "GivenSurfaces/EdgeModels.h"
#include "SharpFeatures/FeatureSites.h"

#include <memory>

namespace vfm
{
namespace
{

constexpr FitRange SmoothRange{ 1.5, 0.7 };
constexpr double NearFoot = 0.6, FarFoot = 1.8; // distances of the surface from a surface point
constexpr double FootCosine = 0.2;              // between the interface and the surface
constexpr double TurnedCost = 0.3; // of a foot whose normal differs by a right angle, in cells

/// Surfaces near one grid, as far as interfaces of this rank need them.
using NearSurfaces = std::vector<std::unique_ptr<const NearSurface>>;

NearSurfaces ListNear(const BodySurfaces& bodies, const LevelSurface& level)
{
  NearSurfaces near;
  for (const PlacedBody& body : bodies.Bodies)
  {
    std::vector<Vector3> points;
    for (const Vector3& x : body.Points)
    {
      points.push_back((1.0 / level.Ratio) * x);
    }
    near.push_back(std::make_unique<const NearSurface>(
      PlacedSurface{ points, body.Triangles, body.Sheets }, level.Source));
  }
  return near;
}

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

  const Vector3& InterfaceNormal() const { return this->Normal; }

  /// Returns the quadric of the surface where it is nearest to the point.
  std::optional<SampleFit> FitSmooth()
  {
    const SurfaceSample* foot = this->FindFoot(NearFoot);
    foot = foot ? foot : this->FindFoot(FarFoot);
    if (!foot)
    {
      return std::nullopt;
    }
    return FitSamples(
      this->Around.Samples, { foot->At, foot->Normal, SurfacePart::AnySheet, {} }, SmoothRange);
  }

  /// Returns the model of the edge nearest to the node.
  std::optional<FeatureModel> FitEdges()
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
    for (SurfaceSample& sample : this->Around.Samples)
    {
      sample.Normal = this->Sign * sample.Normal;
    }
  }

  /// Collects the samples that a fit around a foot needs, and returns the nearest sample within a
  /// distance that faces like the interface, or null.
  const SurfaceSample* FindFoot(double farthest)
  {
    this->List(Norm(this->Start) + farthest + SmoothRange.Radius);
    const SurfaceSample* foot = nullptr;
    double least = 1e30;
    for (const SurfaceSample& sample : this->Around.Samples)
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

} // namespace

SharpFeatures FollowSurfaces(const BodySurfaces& bodies, const LevelSurface& level, bool hasEdges,
  const Partition& partition, Runtime& runtime, SurfaceTargets& targets)
{
  const Interface& interface = level.Source;
  const NearSurfaces near = ListNear(bodies, level);
  const FeatureSites sites(interface, partition);
  const SiteList& list = sites.Near();
  std::vector<std::optional<FeatureModel>> found(list.size());
  ForEach(runtime, list.size(),
    [&](Index i)
    {
      const SurfacePoint& point = interface.Points()[list[i].Point];
      const BodySide side = bodies.Between(point.First, point.Second);
      if (side.Body < 0)
      {
        return;
      }
      const NodeFrame frame = FrameOf(interface, list[i].Node);
      PointSearch search(*near[side.Body], side.IsSecondInside, frame, point);
      const std::optional<SampleFit> fit = search.FitSmooth();
      if (fit)
      {
        targets.Replace(level.FirstTarget + list[i].Point, fit->Surface, level.Ratio * frame.Origin,
          level.Ratio * frame.Widths);
      }
      if (hasEdges)
      {
        found[i] = search.FitEdges();
      }
    });
  std::vector<Index> points;
  std::vector<NodeFeature> models;
  for (std::size_t i = 0; i < list.size(); ++i)
  {
    if (found[i])
    {
      const NodeFrame frame = FrameOf(interface, list[i].Node);
      points.push_back(list[i].Point);
      models.push_back({ *found[i], level.Ratio * frame.Origin, level.Ratio * frame.Widths });
    }
  }
  return SharpFeatures(std::move(points), std::move(models));
}

} // namespace vfm
