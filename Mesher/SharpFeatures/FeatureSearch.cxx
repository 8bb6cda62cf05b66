#include "SharpFeatures/FeatureSearch.h"

#include "SharpFeatures/FeatureFit.h"
#include "SharpFeatures/FeatureStarts.h"

#include <algorithm>

namespace vfm
{
namespace
{

constexpr double Accepted = 0.03; // largest residual of a model
// Largest residual in the narrow stencil, which has less data, of pairs not known to have edges.
constexpr double AcceptedNarrow = 0.01;
// Least factor by which a model must be better than one surface.
constexpr double Gain = 3.0;
// The same two limits of edges in gaps.
constexpr double AcceptedInGap = 0.05, GainInGap = 2.0;
// Least factor over the quadric of the point that needs no other comparison.
constexpr double ClearGain = 12.0;
// Least residual of the quadric for a search in the narrow stencil.
constexpr double NarrowTrigger = 0.06;
constexpr double SmallestArea = 2.0;        // area of each surface of a model
constexpr double SmallestCosine = 0.882948; // 28 degrees, between surfaces of a model
constexpr double SeedCosine = 0.939693;     // 20 degrees, between equal seeds
constexpr double SeedDistance = 0.5;        // distance between equal seeds
constexpr double FarthestSeed = 2.5;        // distance from the node to the foot on the seed
constexpr int SeedSteps = 3;                // Newton iterations to that foot
constexpr std::size_t MaximumSeeds = 4;
constexpr double StartLimit = 0.25;      // largest residual of a model before its fit
constexpr double PlaneLimit = 0.12;      // the same after the fit of planes
constexpr double ThirdLimit = 0.15;      // the same of two surfaces, for a third to be tried
constexpr double ThirdGain = 0.6;        // largest residual of three surfaces relative to two
constexpr std::size_t MaximumStarts = 2; // number of models that are fitted
// Largest residual after each rough iteration.
constexpr std::array<double, 2> RoughLimits{ { 0.16, 0.12 } };
// Largest residual after the first iterations with quadrics, relative to the accepted residual.
constexpr double NearlyAccepted = 1.7;
constexpr int PlaneIterations = 5, FirstQuadricIterations = 2, QuadricIterations = 10,
              SingleIterations = 8, NearIterations = 5;

void Refine(FittedFeature& feature, const PackedCells& cells, int coefficients, int iterations)
{
  FitModel(feature.Model, cells, coefficients, iterations);
  feature.Residual = ResidualOf(feature.Model, cells);
}

void FitQuadrics(FittedFeature& feature, const PackedCells& cells, double accepted, int iterations)
{
  Refine(feature, cells, 6, FirstQuadricIterations);
  if (feature.Residual < NearlyAccepted * accepted)
  {
    Refine(feature, cells, 6, iterations - FirstQuadricIterations);
  }
}

/// Fits planes, then quadrics; stops early if the residual stays high.
FittedFeature FitStart(const FeatureModel& start, const FitData& data)
{
  const PackedCells& cells = data.Cells;
  FittedFeature feature{ start };
  for (double limit : RoughLimits)
  {
    FitModel(feature.Model, cells, 3, 1, SharedCells::Product);
    if (ResidualOf(feature.Model, cells, SharedCells::Product) > limit)
    {
      return {};
    }
  }
  Refine(feature, cells, 3, PlaneIterations);
  if (feature.Residual > ExcellentResidual && feature.Residual <= PlaneLimit)
  {
    FitQuadrics(feature, cells, data.Accepted, QuadricIterations);
  }
  return feature;
}

/// Returns the best model made of `count` of the seeds.
FittedFeature FitSeveral(const FeatureStarts& starts, int count, const FitData& data)
{
  FittedFeature best;
  for (const FeatureStart& start : starts.Best(count, MaximumStarts))
  {
    if (start.Residual > std::min(StartLimit, data.Before))
    {
      break;
    }
    const FittedFeature feature = FitStart(start.Model, data);
    if (feature.Residual < best.Residual)
    {
      best = feature;
    }
    if (best.Residual < ExcellentResidual)
    {
      break;
    }
  }
  return best;
}

bool IsPlausible(const FeatureModel& model, const PackedCells& cells)
{
  const auto areas = AreasOf(model, cells);
  const Vector3 node{};
  for (int i = 0; i < model.Count; ++i)
  {
    Vector3 first;
    DistanceTo(model.Surfaces[i], node, first);
    for (int j = 0; j < i; ++j)
    {
      Vector3 second;
      DistanceTo(model.Surfaces[j], node, second);
      if (Dot(first, second) > SmallestCosine)
      {
        return false;
      }
    }
    if (std::fabs(areas[i]) < SmallestArea)
    {
      return false;
    }
  }
  return true;
}

/// Collects the distinct surfaces of other nodes' models near the node, excellent models first.
std::vector<LocalQuadric> CollectSurfaces(std::vector<NearFeature> others)
{
  std::stable_partition(others.begin(), others.end(),
    [](const NearFeature& other) { return other.Feature->Residual < ExcellentResidual; });
  std::vector<LocalQuadric> seeds;
  for (const NearFeature& other : others)
  {
    for (int k = 0; k < other.Feature->Model.Count && seeds.size() < MaximumSeeds; ++k)
    {
      const LocalQuadric surface = Moved(other.Feature->Model.Surfaces[k], other.From);
      Vector3 normal;
      const Vector3 foot = FootOn(surface, {}, SeedSteps, normal);
      const auto isEqual = [&](const LocalQuadric& seed)
      {
        Vector3 across;
        const double distance = DistanceTo(seed, foot, across);
        return Dot(normal, across) > SeedCosine && std::fabs(distance) < SeedDistance;
      };
      if (Norm(foot) <= FarthestSeed && std::none_of(seeds.begin(), seeds.end(), isEqual))
      {
        seeds.push_back(Recentred(surface, foot));
      }
    }
  }
  return seeds;
}

} // namespace

FeatureSearch::FeatureSearch(const FeatureInput& input, Index node, Index point, bool isSharp) :
  Input(input),
  Node(node),
  IsSharp(isSharp),
  Labels{ { input.Source.Points()[point].First, input.Source.Points()[point].Second } },
  Frame(FrameOf(input.Source, node)),
  Quadric(input.Targets.QuadricOf(input.FirstTarget + point, Frame.Origin, Frame.Widths))
{
}

double FeatureSearch::NearResidual() const
{
  std::vector<SampleCell> cells;
  return GatherCells(this->Input.Source, this->Input.Fractions, this->Frame, this->Labels,
           InnerStencil, cells)
    ? ResidualOf(ModelOf(this->Quadric), cells)
    : 0.0;
}

bool FeatureSearch::Gather()
{
  const bool found = GatherCells(this->Input.Source, this->Input.Fractions, this->Frame,
    this->Labels, WideStencil, this->Around);
  this->Packed = this->Around;
  this->Before = found ? ResidualOf(ModelOf(this->Quadric), this->Packed) : 0.0;
  return found;
}

bool FeatureSearch::IsAccepted(const FittedFeature& feature, const FitData& data) const
{
  const bool isInGap = this->IsInGap && feature.Model.Count == 2;
  const double accepted = isInGap ? AcceptedInGap : data.Accepted;
  const double gain = isInGap ? GainInGap : Gain;
  if (!(feature.Residual < accepted && feature.Residual * gain < data.Before) ||
    !IsPlausible(feature.Model, data.Cells))
  {
    return false;
  }
  if (feature.Residual * ClearGain < data.Before)
  {
    return true;
  }
  FittedFeature single{ ModelOf(this->Quadric), 0.0 };
  Refine(single, data.Cells, 6, SingleIterations);
  return feature.Residual * gain < single.Residual;
}

std::optional<FittedFeature> FeatureSearch::FitSeeds(
  const std::vector<LocalQuadric>& seeds, const FitData& data) const
{
  if (seeds.size() < 2)
  {
    return {};
  }
  const FeatureStarts starts(seeds, data.Cells);
  FittedFeature best = FitSeveral(starts, 2, data);
  const bool mayBeThree = best.Model.Count == 0 || best.Residual < ThirdLimit;
  if (seeds.size() > 2 && best.Residual > ExcellentResidual && mayBeThree)
  {
    const FittedFeature three = FitSeveral(starts, 3, data);
    const double limit = (best.Residual < Accepted ? ThirdGain : 1.0) * best.Residual;
    if (three.Residual < limit && IsPlausible(three.Model, data.Cells))
    {
      best = three;
    }
  }
  return this->IsAccepted(best, data) ? std::optional<FittedFeature>(best) : std::nullopt;
}

std::optional<FittedFeature> FeatureSearch::FromSeeds(const std::vector<LocalQuadric>& seeds) const
{
  const std::optional<FittedFeature> wide =
    this->FitSeeds(seeds, { this->Packed, this->Before, Accepted });
  if (wide)
  {
    return wide;
  }
  // The narrow stencil suits bodies a few cells thick.
  const PackedCells narrow = Narrowed(this->Around, NarrowStencil);
  const double before = ResidualOf(ModelOf(this->Quadric), narrow);
  if (before <= NarrowTrigger)
  {
    return {};
  }
  return this->FitSeeds(seeds, { narrow, before, this->IsSharp ? Accepted : AcceptedNarrow });
}

std::optional<FittedFeature> FeatureSearch::FromCrossings(FaceWalk& walk) const
{
  std::vector<LocalCrossing> crossings;
  GatherCrossings(this->Input.Source, this->Frame, this->Node, this->Labels, walk, crossings);
  return this->FromSeeds(FindPlanes(crossings));
}

std::optional<FittedFeature> FeatureSearch::FromModels(const std::vector<NearFeature>& others) const
{
  FittedFeature best;
  for (const NearFeature& other : others)
  {
    FittedFeature feature = *other.Feature;
    for (LocalQuadric& surface : feature.Model.Surfaces)
    {
      surface = Moved(surface, other.From);
    }
    feature.Residual = ResidualOf(feature.Model, this->Packed);
    if (feature.Residual < best.Residual)
    {
      best = feature;
    }
    if (best.Residual < ExcellentResidual)
    {
      break;
    }
  }
  if (best.Residual > ExcellentResidual && best.Residual < PlaneLimit)
  {
    FitQuadrics(best, this->Packed, Accepted, NearIterations);
  }
  return this->IsAccepted(best, { this->Packed, this->Before, Accepted })
    ? std::optional<FittedFeature>(best)
    : std::nullopt;
}

std::optional<FittedFeature> FeatureSearch::FromSurfaces(
  const std::vector<NearFeature>& others) const
{
  return this->FromSeeds(CollectSurfaces(others));
}

} // namespace vfm
