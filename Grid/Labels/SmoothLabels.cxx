#include "Labels/SmoothLabels.h"

#include "Base/PairSums.h"
#include "Base/PortableMath.h"
#include "Base/Sorted.h"
#include "Fractions/AverageFractions.h"
#include "Fractions/FractionSum.h"
#include "Fractions/GhostFractions.h"
#include "Fractions/SharpFractions.h"
#include "Labels/Labels.h"

#include <cmath>
#include <mutex>

namespace vfm
{
namespace
{

using Part = FractionField::Part;

constexpr double LeastFloor = 0.501; // least fraction of the own label of a cell
constexpr int MiddleOfPatch = 13;
constexpr int WeightRounds = 5;         // rounds that move the interfaces
constexpr double WeightsAreGood = 1e-4; // relative error of volumes at which they end
constexpr double LargestWeightStep = 0.3;
constexpr int ScaleRounds = 60; // rounds that scale the fractions
constexpr double VolumesAreGood = 1e-9;
constexpr double LargestScaleStep = 1.0;
constexpr double Negligible = 1e-9; // smaller fractions count as 0

/// Cell that may become mixed.
struct ActiveCell
{
  Index3 Position;
  int Label;
  double Volume;           // in volumes of a mean cell
  double Floor;            // least fraction of its label
  std::vector<Part> Parts; // ascending by material
};

/// Volumes by material, and the rates at which materials gain volume from each other.
struct Tally
{
  std::vector<ExactSum> Volumes;
  PairSumMap Rates;

  explicit Tally(std::size_t materials) : Volumes(materials) {}
  void AddVolumes(const ActiveCell& cell)
  {
    for (const Part& part : cell.Parts)
    {
      this->Volumes[part.Material].Add(part.Fraction * cell.Volume);
    }
  }
  void AddRate(int first, int second, double rate)
  {
    this->Rates[std::minmax(first, second)].Add(rate);
  }
  void Add(const Tally& other)
  {
    for (std::size_t m = 0; m < this->Volumes.size(); ++m)
    {
      this->Volumes[m].Add(other.Volumes[m]);
    }
    for (const auto& rate : other.Rates)
    {
      this->Rates[rate.first].Add(rate.second);
    }
  }
};

double OwnFraction(const ActiveCell& cell)
{
  return FractionField::FractionOf(cell.Parts, cell.Label);
}

/// Sets the own label of a cell to its floor and scales the others to the rest.
void RaiseOwn(ActiveCell& cell)
{
  const double scale = (1.0 - cell.Floor) / (1.0 - OwnFraction(cell));
  PartOf(cell.Parts, cell.Label);
  for (Part& part : cell.Parts)
  {
    part.Fraction = part.Material == cell.Label ? cell.Floor : part.Fraction * scale;
  }
}

/// Returns the floor of a cell. The weaker its label is at its centre, the thinner is the part to
/// which it belongs, and the more of the cell it keeps. A single cell stays nearly full.
double FindFloor(const ActiveCell& cell, const std::vector<MaterialPatch>& patches)
{
  double own = 0.0, other = 0.0;
  for (const MaterialPatch& patch : patches)
  {
    const double value = patch.Values[MiddleOfPatch];
    (patch.Material == cell.Label ? own : other) =
      patch.Material == cell.Label ? value : std::max(other, value);
  }
  return std::max(LeastFloor, other / (own + other));
}

struct Work
{
  const CartesianGrid& Grid;
  const Partition& Parts;
  Runtime& Run;
  const LabelArray Labels;
  std::vector<double> Lack; // volume that is missing in the cells, by material
  std::vector<double> Weights = std::vector<double>(Lack.size(), 1.0); // factors of the fields
  Tally Last{ Lack.size() };
  std::vector<ActiveCell> Cells{};
  std::vector<double> Totals{}; // volumes of the labels, in mean cells
};

/// Finds the cells of this rank at interfaces, and the volumes of all labels.
void FindCells(Work& work)
{
  const CartesianGrid& grid = work.Grid;
  const double scale = 1.0 / Cube(grid.MeanWidth());
  PagedArray<unsigned char> isActive(grid, 0);
  for (Index node : FindMixedNodes(grid, work.Labels))
  {
    for (int c = 0; c < 8; ++c)
    {
      isActive.Set(grid.CellOfNode(node, c), 1);
    }
  }
  std::vector<ExactSum> totals(work.Lack.size());
  work.Parts.ForCells(grid.Owned(),
    [&](Index cell)
    {
      const Index3 p = grid.Position(cell);
      const double volume = grid.CellVolume(p) * scale;
      const int label = work.Labels[cell];
      totals[label].Add(volume);
      if (isActive[cell])
      {
        work.Cells.push_back({ p, label, volume, LeastFloor, { { label, 1.0 } } });
      }
    });
  work.Totals = SumOverRanks(totals, work.Parts.Group());
}

/// Returns the largest relative error of a volume.
double Error(const Work& work)
{
  double worst = 0.0;
  for (std::size_t m = 0; m < work.Lack.size(); ++m)
  {
    if (work.Totals[m] > 0.0)
    {
      worst = std::max(worst, std::fabs(work.Lack[m]) / work.Totals[m]);
    }
  }
  return worst;
}

/// Calls body(cell, tally) for the active cells on several threads; sets Last and Lack.
template <class Body>
void Visit(Work& work, const Body& body)
{
  Tally sum(work.Lack.size());
  std::mutex mutex;
  work.Run.For(0, static_cast<Index>(work.Cells.size()),
    [&](Index begin, Index end)
    {
      Tally mine(work.Lack.size());
      for (Index c = begin; c < end; ++c)
      {
        mine.Volumes[work.Cells[c].Label].Add(-work.Cells[c].Volume);
        body(work.Cells[c], mine);
        mine.AddVolumes(work.Cells[c]);
      }
      const std::lock_guard<std::mutex> lock(mutex);
      sum.Add(mine);
    });
  work.Last = std::move(sum);
  work.Lack = SumOverRanks(work.Last.Volumes, work.Parts.Group());
  for (double& lack : work.Lack)
  {
    lack = -lack;
  }
}

/// Returns the labels of a cell and of the 26 around it, ascending.
std::vector<int> LabelsAround(const Work& work, const Index3& cell)
{
  std::vector<int> found;
  for (int v = 0; v < 27; ++v)
  {
    found.push_back(work.Labels[work.Grid.Linear(CellAround(cell, v))]);
  }
  SortUnique(found);
  return found;
}

void PartCell(const Work& work, const FractionField& smooth, ActiveCell& cell, Tally& tally)
{
  std::vector<PairRate> rates;
  const std::vector<MaterialPatch> patches =
    MakePatches(work.Grid, smooth, cell.Position, LabelsAround(work, cell.Position), work.Weights);
  cell.Parts = FindSharpFractions(patches, &rates);
  cell.Floor = FindFloor(cell, patches);
  if (OwnFraction(cell) < cell.Floor)
  {
    RaiseOwn(cell);
    return;
  }
  for (const PairRate& rate : rates)
  {
    tally.AddRate(rate.First, rate.Second, rate.Rate * cell.Volume);
  }
}

std::vector<double> FindSteps(Work& work, double largest)
{
  std::vector<double> steps =
    SolveForLack(GatherPairSums(work.Last.Rates, work.Parts.Group()), work.Lack);
  for (double& step : steps)
  {
    step = Exp(std::min(std::max(step, -largest), largest));
  }
  return steps;
}

/// Moves the interfaces until the volumes are nearly right.
void PartCells(Work& work, const FractionField& smooth)
{
  for (int round = 0; round < WeightRounds; ++round)
  {
    Visit(work, [&](ActiveCell& cell, Tally& tally) { PartCell(work, smooth, cell, tally); });
    if (Error(work) < WeightsAreGood || round + 1 == WeightRounds)
    {
      break;
    }
    const std::vector<double> steps = FindSteps(work, LargestWeightStep);
    for (std::size_t m = 0; m < steps.size(); ++m)
    {
      work.Weights[m] *= steps[m];
    }
  }
}

void ScaleCell(ActiveCell& cell, const std::vector<double>& factors)
{
  double sum = 0.0;
  for (Part& part : cell.Parts)
  {
    part.Fraction *= factors[part.Material];
    sum += part.Fraction;
  }
  for (Part& part : cell.Parts)
  {
    part.Fraction /= sum;
  }
  if (OwnFraction(cell) < cell.Floor)
  {
    RaiseOwn(cell);
  }
}

/// Adds the rates at which the materials of a cell gain from each other when they are scaled. A
/// label at its floor loses nothing.
void AddRates(const Work& work, const ActiveCell& cell, Tally& tally)
{
  const bool isHeld = OwnFraction(cell) <= cell.Floor && work.Lack[cell.Label] <= 0.0;
  for (auto a = cell.Parts.begin(); a != cell.Parts.end(); ++a)
  {
    for (auto b = a + 1; b != cell.Parts.end(); ++b)
    {
      if (!isHeld || (a->Material != cell.Label && b->Material != cell.Label))
      {
        tally.AddRate(a->Material, b->Material, a->Fraction * b->Fraction * cell.Volume);
      }
    }
  }
}

/// Scales fractions until the volumes are right.
void ScaleFractions(Work& work)
{
  std::vector<double> factors(work.Lack.size(), 1.0);
  for (int round = 0; round < ScaleRounds; ++round)
  {
    Visit(work,
      [&](ActiveCell& cell, Tally& tally)
      {
        ScaleCell(cell, factors);
        AddRates(work, cell, tally);
      });
    if (Error(work) < VolumesAreGood)
    {
      break;
    }
    factors = FindSteps(work, LargestScaleStep);
  }
}

void Store(const Work& work, FractionField& labels)
{
  for (const ActiveCell& cell : work.Cells)
  {
    std::vector<Part> parts;
    for (const Part& part : cell.Parts)
    {
      if (part.Fraction > Negligible)
      {
        parts.push_back(part);
      }
    }
    labels.CopyParts(work.Grid.Linear(cell.Position), parts);
  }
}

} // namespace

double SmoothLabels(const CartesianGrid& grid, int passes, const Partition& partition,
  Runtime& runtime, FractionField& labels)
{
  Work work{ grid, partition, runtime, AssignMaterials(grid, labels, 0.5),
    std::vector<double>(labels.NumberOfMaterials() + 1, 0.0) };
  FindCells(work);
  PartCells(work, AverageFractions(grid, labels, passes, partition, runtime));
  ScaleFractions(work);
  Store(work, labels);
  FillGhosts(partition, labels);
  return Error(work);
}

} // namespace vfm
