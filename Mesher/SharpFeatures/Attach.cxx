#include "SharpFeatures/Attach.h"

#include "SharpFeatures/FeaturePlaces.h"

namespace vfm
{
namespace
{

// Largest distance of a side from the initial position of a point, in cells.
constexpr double FarthestSide = 1.5;
// Largest cosine between the normals of surfaces that face each other.
constexpr double SheetCosine = -0.9;

/// Weights of squared distances; the weight of quadrics is 1.
struct FeatureWeights
{
  double Side, Carrier;
};
constexpr FeatureWeights HexWeights{ 4.0, 20.0 }, TetWeights{ 12.0, 30.0 };

/// Model for a pair at a point, or nullptr, and the initial position of the point in the
/// frame of the model.
struct ModelAt
{
  const NodeFeature* Feature;
  Vector3 Start;
};

ModelAt FindModel(const SharpFeatures& models, const SurfacePairs& pairs, Index point, Index pair)
{
  const NodeFeature* feature = pairs.IsOwned[point] ? models.Find(pairs.Target[pair]) : nullptr;
  return feature
    ? ModelAt{ feature, Divided(pairs.Places[point] - feature->Origin, feature->Widths) }
    : ModelAt{ nullptr, {} };
}

/// Returns whether a model consists of two surfaces that face each other across a thin gap or film.
bool IsSheet(const FeatureModel& model)
{
  Vector3 first, second;
  DistanceTo(model.Surfaces[0], {}, first);
  DistanceTo(model.Surfaces[1], {}, second);
  return model.Count == 2 && Dot(first, second) < SheetCosine;
}

FeaturePoint PointOf(const ModelAt& at)
{
  const FeatureModel& model = at.Feature->Model;
  const SidePlace side = FindSide(model, at.Start);
  const std::optional<EdgePlace> edge = FindEdge(model, at.Start);
  const std::optional<CornerPlace> corner = FindCorner(model, at.Start);
  FeaturePoint point;
  point.Kind = side.Distance < FarthestSide ? FeatureKind::Side : FeatureKind::None;
  point.Normal = side.Normal;
  point.IsSheet = IsSheet(model);
  if (edge)
  {
    point.EdgeDistance = BluntnessOf(edge->Normals[0], edge->Normals[1]) * edge->Distance;
    point.EdgeNormals = edge->Normals;
  }
  if (corner)
  {
    point.Corner = at.Feature->Origin + Scaled(corner->Point, at.Feature->Widths);
    point.CornerDistance = corner->Bluntness * corner->Distance;
  }
  return point;
}

/// Returns the place of each pair relative to its model.
std::vector<FeaturePoint> Classify(
  const SharpFeatures& models, const SurfacePairs& pairs, Runtime& runtime)
{
  std::vector<FeaturePoint> points(pairs.Labels.size());
  ForEach(runtime, pairs.Ids.size(),
    [&](Index p)
    {
      for (Index i = pairs.Offset[p]; i < pairs.Offset[p + 1]; ++i)
      {
        const ModelAt at = FindModel(models, pairs, p, i);
        if (at.Feature)
        {
          points[i] = PointOf(at);
        }
      }
    });
  return points;
}

/// Returns the highest kind of the pairs of each point.
std::vector<FeatureKind> KindsOfPoints(
  const SurfacePairs& pairs, const std::vector<FeaturePoint>& points)
{
  std::vector<FeatureKind> kinds(pairs.Ids.size(), FeatureKind::None);
  for (std::size_t p = 0; p < kinds.size(); ++p)
  {
    for (Index i = pairs.Offset[p]; i < pairs.Offset[p + 1]; ++i)
    {
      kinds[p] = std::max(kinds[p], points[i].Kind);
    }
  }
  pairs.Exchange.SendAll([&](int mover) { return kinds[mover]; },
    [&](int mover, FeatureKind kind) { kinds[mover] = kind; });
  return kinds;
}

/// Adds the surfaces that attract a point of a kind to the targets, and sets bluntness to that of
/// its edge, or 1.
FeaturePull MakePull(
  const ModelAt& at, FeatureKind kind, bool isOfHexes, SurfaceTargets& targets, double& bluntness)
{
  const FeatureModel& model = at.Feature->Model;
  const FeatureWeights& weights = isOfHexes ? HexWeights : TetWeights;
  FeaturePull pull;
  pull.Weight = kind == FeatureKind::Side ? weights.Side : weights.Carrier;
  const auto add = [&](int surface, const Vector3& place)
  {
    pull.Targets[pull.Count++] = targets.Add(
      Recentred(model.Surfaces[surface], place), at.Feature->Origin, at.Feature->Widths);
  };
  bluntness = 1.0;
  if (kind == FeatureKind::Corner)
  {
    const CornerPlace corner = *FindCorner(model, at.Start);
    for (int surface = 0; surface < 3; ++surface)
    {
      add(surface, corner.Point);
    }
    bluntness = corner.Bluntness;
  }
  else if (kind == FeatureKind::Edge)
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

std::array<int, 2> InterfaceFeatures::LabelsOf(Index target) const
{
  Index point = target - this->FirstTarget;
  for (const Interface* source : this->Sources)
  {
    const Index count = static_cast<Index>(source->Points().size());
    if (point >= 0 && point < count)
    {
      return { { source->Points()[point].First, source->Points()[point].Second } };
    }
    point -= count;
  }
  return { { -1, -1 } };
}

FeaturePulls PullToFeatures(const InterfaceFeatures& features, const SurfacePairs& pairs,
  const std::vector<Facet>& facets, SurfaceTargets& targets, Runtime& runtime)
{
  std::vector<FeaturePoint> points = Classify(features.Models, pairs, runtime);
  ApplyFeatureRules(pairs, facets, points);
  FeaturePulls pulls{ std::vector<FeaturePull>(points.size()), KindsOfPoints(pairs, points),
    std::vector<unsigned char>(pairs.Ids.size(), 0), std::vector<float>(pairs.Ids.size(), 1.0f) };
  for (std::size_t p = 0; p < pairs.Ids.size(); ++p)
  {
    for (Index i = pairs.Offset[p]; i < pairs.Offset[p + 1]; ++i)
    {
      const ModelAt at = FindModel(features.Models, pairs, p, i);
      if (at.Feature && points[i].Kind != FeatureKind::None)
      {
        double bluntness;
        pulls.OfPairs[i] = MakePull(at, points[i].Kind, pairs.IsOfHexes, targets, bluntness);
        pulls.Fade[p] |= at.Feature->Fades;
        pulls.Bluntness[p] = std::min(pulls.Bluntness[p], static_cast<float>(bluntness));
      }
    }
  }
  return pulls;
}

} // namespace vfm
