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
constexpr std::size_t MostSeeds = 4;
constexpr double StartLimit = 0.25;   // residual of a model before its fit
constexpr double PlaneLimit = 0.12;   // after the fit of planes
constexpr double ThirdLimit = 0.15;   // of two surfaces, for a third to be tried
constexpr double ThirdGain = 0.6;     // of three surfaces over two
constexpr std::size_t MostStarts = 2; // that are fitted
constexpr std::array<double, 2> RoughLimits{ { 0.16, 0.12 } }; // after each rough iteration
constexpr int PlaneIterations = 10, QuadricIterations = 10, SingleIterations = 8,
              NearIterations = 5;

void Refine(FittedCrease& crease, const PackedCells& cells, int coefficients, int iterations)
{
  FitModel(crease.Model, cells, coefficients, iterations);
  crease.Residual = ResidualOf(crease.Model, cells);
}

/// Planes first, then quadrics; given up where it leads nowhere.
FittedCrease FitStart(const CreaseModel& start, const PackedCells& cells)
{
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
    Refine(crease, cells, 6, QuadricIterations);
  }
  return crease;
}

/// The best model of so many of the seeds.
FittedCrease FitSeveral(
  const CreaseStarts& starts, int count, const PackedCells& cells, double before)
{
  FittedCrease best;
  for (const CreaseStart& start : starts.Best(count, MostStarts))
  {
    if (start.Residual > std::min(StartLimit, before))
    {
      break;
    }
    const FittedCrease crease = FitStart(start.Model, cells);
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

Vector3 FootOf(const LocalQuadric& surface, Vector3& normal)
{
  Vector3 foot{};
  for (int step = 0; step < 3; ++step)
  {
    foot = foot - DistanceTo(surface, foot, normal) * normal;
  }
  return foot;
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
      const Vector3 foot = FootOf(surface, normal);
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

bool CreaseSearch::IsAccepted(
  const FittedCrease& crease, const PackedCells& cells, double before) const
{
  if (!(crease.Residual < Accepted && crease.Residual * Gain < before) ||
    !IsPlausible(crease.Model, cells))
  {
    return false;
  }
  if (crease.Residual * ClearGain < before)
  {
    return true;
  }
  FittedCrease single{ ModelOf(this->Quadric), 0.0 };
  Refine(single, cells, 6, SingleIterations);
  return crease.Residual * Gain < single.Residual;
}

std::optional<FittedCrease> CreaseSearch::FitSeeds(
  const std::vector<LocalQuadric>& seeds, const PackedCells& cells, double before) const
{
  if (seeds.size() < 2)
  {
    return {};
  }
  const CreaseStarts starts(seeds, cells);
  FittedCrease best = FitSeveral(starts, 2, cells, before);
  const bool mayBeThree = best.Model.Count == 0 || best.Residual < ThirdLimit;
  if (seeds.size() > 2 && best.Residual > ExcellentResidual && mayBeThree)
  {
    const FittedCrease three = FitSeveral(starts, 3, cells, before);
    const double limit = (best.Residual < Accepted ? ThirdGain : 1.0) * best.Residual;
    if (three.Residual < limit && IsPlausible(three.Model, cells))
    {
      best = three;
    }
  }
  return this->IsAccepted(best, cells, before) ? std::optional<FittedCrease>(best) : std::nullopt;
}

std::optional<FittedCrease> CreaseSearch::FromSeeds(const std::vector<LocalQuadric>& seeds) const
{
  const std::optional<FittedCrease> wide = this->FitSeeds(seeds, this->Packed, this->Before);
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
  std::optional<FittedCrease> crease = this->FitSeeds(seeds, narrow, before);
  const double limit = this->IsSharp ? Accepted : AcceptedNarrow;
  return crease && crease->Residual <= limit ? crease : std::nullopt;
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
    Refine(best, this->Packed, 6, NearIterations);
  }
  return this->IsAccepted(best, this->Packed, this->Before) ? std::optional<FittedCrease>(best)
                                                            : std::nullopt;
}

std::optional<FittedCrease> CreaseSearch::FromSurfaces(const std::vector<NearCrease>& others) const
{
  return this->FromSeeds(CollectSurfaces(others));
}

} // namespace vfm
