#include "Creases/CreaseSearch.h"

#include "Creases/CreaseFit.h"
#include "Creases/CreaseStarts.h"

#include <algorithm>

namespace vfm
{
namespace
{

constexpr double Accepted = 0.03; // largest residual of a model
constexpr double AcceptedNarrow =
  0.01; // of one in the narrow stencil, which has less data, where the pair is not known to have edges
constexpr double Gain = 3.0;                // by which it must be below those of one surface
constexpr double ClearGain = 12.0;          // at which the point's own quadric is enough to tell
constexpr double NarrowTrigger = 0.06;      // least residual of the quadric in the narrow stencil
constexpr double SmallestArea = 2.0;        // of a surface of a model
constexpr double SmallestCosine = 0.882948; // of 28 degrees, between surfaces of a model
constexpr double SeedCosine = 0.939693;     // of 20 degrees, between seeds that are alike
constexpr double SeedDistance = 0.5;        // the same
constexpr double FarthestSeed = 2.5;        // its foot from the node
constexpr int SeedSteps = 3;                // of Newton, to that foot
constexpr std::size_t MostSeeds = 4;
constexpr double StartLimit = 0.25;   // residual of a model before its fit
constexpr double PlaneLimit = 0.12;   // after the fit of planes
constexpr double ThirdLimit = 0.15;   // of two surfaces, for a third to be tried
constexpr double ThirdGain = 0.6;     // of three surfaces over two
constexpr std::size_t MostStarts = 2; // that are fitted
constexpr std::array<double, 2> RoughLimits{ { 0.16, 0.12 } }; // after each rough iteration
constexpr double NearlyAccepted =
  1.7; // times the largest accepted residual, after the first iterations with quadrics
constexpr int PlaneIterations = 5, FirstQuadricIterations = 2, QuadricIterations = 10,
              SingleIterations = 8, NearIterations = 5;

void Refine(FittedCrease& crease, const PackedCells& cells, int coefficients, int iterations)
{
  FitModel(crease.Model, cells, coefficients, iterations);
  crease.Residual = ResidualOf(crease.Model, cells);
}

void FitQuadrics(FittedCrease& crease, const PackedCells& cells, double accepted, int iterations)
{
  Refine(crease, cells, 6, FirstQuadricIterations);
  if (crease.Residual < NearlyAccepted * accepted)
  {
    Refine(crease, cells, 6, iterations - FirstQuadricIterations);
  }
}

/// Planes first, then quadrics; given up where it leads nowhere.
FittedCrease FitStart(const CreaseModel& start, const FitData& data)
{
  const PackedCells& cells = data.Cells;
  FittedCrease crease{ start };
  for (double limit : RoughLimits)
  {
    FitModel(crease.Model, cells, 3, 1, SharedCells::Product);
    if (ResidualOf(crease.Model, cells, SharedCells::Product) > limit)
    {
      return {};
    }
  }
  Refine(crease, cells, 3, PlaneIterations);
  if (crease.Residual > ExcellentResidual && crease.Residual <= PlaneLimit)
  {
    FitQuadrics(crease, cells, data.Accepted, QuadricIterations);
  }
  return crease;
}

/// The best model of so many of the seeds.
FittedCrease FitSeveral(const CreaseStarts& starts, int count, const FitData& data)
{
  FittedCrease best;
  for (const CreaseStart& start : starts.Best(count, MostStarts))
  {
    if (start.Residual > std::min(StartLimit, data.Before))
    {
      break;
    }
    const FittedCrease crease = FitStart(start.Model, data);
    if (crease.Residual < best.Residual)
    {
      best = crease;
    }
    if (best.Residual < ExcellentResidual)
    {
      break;
    }
  }
  return best;
}

bool IsPlausible(const CreaseModel& model, const PackedCells& cells)
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

/// The different surfaces of other nodes' models near the node; those of excellent models first.
std::vector<LocalQuadric> CollectSurfaces(std::vector<NearCrease> others)
{
  std::stable_partition(others.begin(), others.end(),
    [](const NearCrease& other) { return other.Crease->Residual < ExcellentResidual; });
  std::vector<LocalQuadric> seeds;
  for (const NearCrease& other : others)
  {
    for (int k = 0; k < other.Crease->Model.Count && seeds.size() < MostSeeds; ++k)
    {
      const LocalQuadric surface = Moved(other.Crease->Model.Surfaces[k], other.From);
      Vector3 normal;
      const Vector3 foot = FootOn(surface, {}, SeedSteps, normal);
      const auto isAlike = [&](const LocalQuadric& seed)
      {
        Vector3 across;
        const double distance = DistanceTo(seed, foot, across);
        return Dot(normal, across) > SeedCosine && std::fabs(distance) < SeedDistance;
      };
      if (Norm(foot) <= FarthestSeed && std::none_of(seeds.begin(), seeds.end(), isAlike))
      {
        seeds.push_back(Recentred(surface, foot));
      }
    }
  }
  return seeds;
}

} // namespace

CreaseSearch::CreaseSearch(const CreaseInput& input, Index node, Index point, bool isSharp) :
  Input(input),
  Node(node),
  IsSharp(isSharp),
  Labels{ { input.Source.Points()[point].First, input.Source.Points()[point].Second } },
  Frame(FrameOf(input.Source, node)),
  Quadric(input.Targets.QuadricOf(input.FirstTarget + point, Frame.Origin, Frame.Widths))
{
}

double CreaseSearch::NearResidual() const
{
  std::vector<SampleCell> cells;
  return GatherCells(this->Input.Source, this->Input.Fractions, this->Frame, this->Labels,
           InnerStencil, cells)
    ? ResidualOf(ModelOf(this->Quadric), cells)
    : 0.0;
}

bool CreaseSearch::Gather()
{
  const bool found = GatherCells(this->Input.Source, this->Input.Fractions, this->Frame,
    this->Labels, WideStencil, this->Around);
  this->Packed = this->Around;
  this->Before = found ? ResidualOf(ModelOf(this->Quadric), this->Packed) : 0.0;
  return found;
}

bool CreaseSearch::IsAccepted(const FittedCrease& crease, const FitData& data) const
{
  if (!(crease.Residual < data.Accepted && crease.Residual * Gain < data.Before) ||
    !IsPlausible(crease.Model, data.Cells))
  {
    return false;
  }
  if (crease.Residual * ClearGain < data.Before)
  {
    return true;
  }
  FittedCrease single{ ModelOf(this->Quadric), 0.0 };
  Refine(single, data.Cells, 6, SingleIterations);
  return crease.Residual * Gain < single.Residual;
}

std::optional<FittedCrease> CreaseSearch::FitSeeds(
  const std::vector<LocalQuadric>& seeds, const FitData& data) const
{
  if (seeds.size() < 2)
  {
    return {};
  }
  const CreaseStarts starts(seeds, data.Cells);
  FittedCrease best = FitSeveral(starts, 2, data);
  const bool mayBeThree = best.Model.Count == 0 || best.Residual < ThirdLimit;
  if (seeds.size() > 2 && best.Residual > ExcellentResidual && mayBeThree)
  {
    const FittedCrease three = FitSeveral(starts, 3, data);
    const double limit = (best.Residual < Accepted ? ThirdGain : 1.0) * best.Residual;
    if (three.Residual < limit && IsPlausible(three.Model, data.Cells))
    {
      best = three;
    }
  }
  return this->IsAccepted(best, data) ? std::optional<FittedCrease>(best) : std::nullopt;
}

std::optional<FittedCrease> CreaseSearch::FromSeeds(const std::vector<LocalQuadric>& seeds) const
{
  const std::optional<FittedCrease> wide =
    this->FitSeeds(seeds, { this->Packed, this->Before, Accepted });
  if (wide)
  {
    return wide;
  }
  const PackedCells narrow = Narrowed(this->Around, NarrowStencil); // of bodies a few cells thick
  const double before = ResidualOf(ModelOf(this->Quadric), narrow);
  if (before <= NarrowTrigger)
  {
    return {};
  }
  return this->FitSeeds(seeds, { narrow, before, this->IsSharp ? Accepted : AcceptedNarrow });
}

std::optional<FittedCrease> CreaseSearch::FromCrossings(FaceWalk& walk) const
{
  std::vector<LocalCrossing> crossings;
  GatherCrossings(this->Input.Source, this->Frame, this->Node, this->Labels, walk, crossings);
  return this->FromSeeds(FindPlanes(crossings));
}

std::optional<FittedCrease> CreaseSearch::FromModels(const std::vector<NearCrease>& others) const
{
  FittedCrease best;
  for (const NearCrease& other : others)
  {
    FittedCrease crease = *other.Crease;
    for (LocalQuadric& surface : crease.Model.Surfaces)
    {
      surface = Moved(surface, other.From);
    }
    crease.Residual = ResidualOf(crease.Model, this->Packed);
    if (crease.Residual < best.Residual)
    {
      best = crease;
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
    ? std::optional<FittedCrease>(best)
    : std::nullopt;
}

std::optional<FittedCrease> CreaseSearch::FromSurfaces(const std::vector<NearCrease>& others) const
{
  return this->FromSeeds(CollectSurfaces(others));
}

} // namespace vfm
