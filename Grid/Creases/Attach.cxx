#include "Creases/Attach.h"

#include "Creases/CreasePlaces.h"

namespace vfm
{
namespace
{

constexpr double FarthestSide = 1.5; // from where a point started, in cells
constexpr double SheetCosine = -0.9; // between the normals of surfaces that face each other

/// Of squared distances, against 1 of quadrics.
struct CreaseWeights
{
  double Side, Carrier;
};
constexpr CreaseWeights HexWeights{ 4.0, 20.0 }, TetWeights{ 12.0, 30.0 };

/// The model that holds for a pair at a point, nullptr: none, and where the point started in the frame of the model.
struct ModelAt
{
  const NodeCrease* Crease;
  Vector3 Start;
};

ModelAt FindModel(const Creases& models, const SurfacePairs& pairs, Index point, Index pair)
{
  const Index surfacePoint = pairs.SurfacePoint[pair];
  const NodeCrease* crease =
    pairs.IsOwned[point] && surfacePoint >= 0 ? models.Find(surfacePoint) : nullptr;
  return crease ? ModelAt{ crease, Divided(pairs.Places[point] - crease->Origin, crease->Widths) }
                : ModelAt{ nullptr, {} };
}

/// Whether a model is two surfaces that face each other, with a thin gap or film between them.
bool IsSheet(const CreaseModel& model)
{
  Vector3 first, second;
  DistanceTo(model.Surfaces[0], {}, first);
  DistanceTo(model.Surfaces[1], {}, second);
  return model.Count == 2 && Dot(first, second) < SheetCosine;
}

CreasePoint PointOf(const ModelAt& at)
{
  const CreaseModel& model = at.Crease->Model;
  const SidePlace side = FindSide(model, at.Start);
  const std::optional<EdgePlace> edge = FindEdge(model, at.Start);
  const std::optional<CornerPlace> corner = FindCorner(model, at.Start);
  CreasePoint point;
  point.Kind = side.Distance < FarthestSide ? CreaseKind::Side : CreaseKind::None;
  point.Normal = side.Normal;
  point.IsSheet = IsSheet(model);
  if (edge)
  {
    point.EdgeDistance = BluntnessOf(edge->Normals[0], edge->Normals[1]) * edge->Distance;
    point.EdgeNormals = edge->Normals;
  }
  if (corner)
  {
    point.Corner = at.Crease->Origin + Scaled(corner->Point, at.Crease->Widths);
    point.CornerDistance = corner->Bluntness * corner->Distance;
  }
  return point;
}

/// Of each pair.
std::vector<CreasePoint> Classify(
  const Creases& models, const SurfacePairs& pairs, Runtime& runtime)
{
  std::vector<CreasePoint> points(pairs.Labels.size());
  ForEach(runtime, pairs.Ids.size(),
    [&](Index p)
    {
      for (Index i = pairs.Offset[p]; i < pairs.Offset[p + 1]; ++i)
      {
        const ModelAt at = FindModel(models, pairs, p, i);
        if (at.Crease)
        {
          points[i] = PointOf(at);
        }
      }
    });
  return points;
}

/// The highest kind of the pairs of each point.
std::vector<CreaseKind> KindsOfPoints(
  const SurfacePairs& pairs, const std::vector<CreasePoint>& points)
{
  std::vector<CreaseKind> kinds(pairs.Ids.size(), CreaseKind::None);
  for (std::size_t p = 0; p < kinds.size(); ++p)
  {
    for (Index i = pairs.Offset[p]; i < pairs.Offset[p + 1]; ++i)
    {
      kinds[p] = std::max(kinds[p], points[i].Kind);
    }
  }
  pairs.Exchange.SendAll([&](int mover) { return kinds[mover]; },
    [&](int mover, CreaseKind kind) { kinds[mover] = kind; });
  return kinds;
}

/// Adds what a point of some kind is drawn to; bluntness: of the edge there, 1 without one.
CreasePull MakePull(
  const ModelAt& at, CreaseKind kind, bool isOfHexes, SurfaceTargets& targets, double& bluntness)
{
  const CreaseModel& model = at.Crease->Model;
  const CreaseWeights& weights = isOfHexes ? HexWeights : TetWeights;
  CreasePull pull;
  pull.Weight = kind == CreaseKind::Side ? weights.Side : weights.Carrier;
  const auto add = [&](int surface, const Vector3& place)
  {
    pull.Targets[pull.Count++] =
      targets.Add(Recentred(model.Surfaces[surface], place), at.Crease->Origin, at.Crease->Widths);
  };
  bluntness = 1.0;
  if (kind == CreaseKind::Corner)
  {
    const CornerPlace corner = *FindCorner(model, at.Start);
    for (int surface = 0; surface < 3; ++surface)
    {
      add(surface, corner.Point);
    }
    bluntness = corner.Bluntness;
  }
  else if (kind == CreaseKind::Edge)
  {
    const EdgePlace edge = *FindEdge(model, at.Start);
    add(edge.Surfaces[0], edge.Point);
    add(edge.Surfaces[1], edge.Point);
    bluntness = BluntnessOf(edge.Normals[0], edge.Normals[1]);
  }
  else
  {
    const SidePlace side = FindSide(model, at.Start);
    add(side.Surface, side.Foot);
  }
  return pull;
}

} // namespace

CreasePulls PullToCreases(const InterfaceCreases& creases, const SurfacePairs& pairs,
  const std::vector<Facet>& facets, SurfaceTargets& targets, Runtime& runtime)
{
  std::vector<CreasePoint> points = Classify(creases.Models, pairs, runtime);
  ApplyCreaseRules(pairs, facets, points);
  CreasePulls pulls{ std::vector<CreasePull>(points.size()), KindsOfPoints(pairs, points),
    std::vector<float>(pairs.Ids.size(), 1.0f) };
  for (std::size_t p = 0; p < pairs.Ids.size(); ++p)
  {
    for (Index i = pairs.Offset[p]; i < pairs.Offset[p + 1]; ++i)
    {
      const ModelAt at = FindModel(creases.Models, pairs, p, i);
      if (at.Crease && points[i].Kind != CreaseKind::None)
      {
        double bluntness;
        pulls.OfPairs[i] = MakePull(at, points[i].Kind, pairs.IsOfHexes, targets, bluntness);
        pulls.Bluntness[p] = std::min(pulls.Bluntness[p], static_cast<float>(bluntness));
      }
    }
  }
  return pulls;
}

} // namespace vfm
