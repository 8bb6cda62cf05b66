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
#include <sstream>

namespace vfm
{
namespace
{

using Part = FractionField::Part;

constexpr double LeastFloor = 0.501; // least fraction of the own label of a cell
constexpr int MiddleOfPatch = 13;
constexpr double VolumeTolerance = 1e-6; // relative error of volumes without a warning
constexpr int WeightRounds = 5;          // rounds that move the interfaces
constexpr double WeightsAreGood = 1e-4;  // relative error of volumes at which they end
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

/// Cells of this rank that may become mixed, and the volumes of all labels.
struct ActiveCells
{
  Ranks& Group;
  Runtime& Run;
  std::vector<ActiveCell> Cells{};
  std::vector<double> Totals{}; // volumes of the labels over all ranks, in mean cells
};

/// Result of a round that changes the cells.
struct Balance
{
  std::vector<double> Lack; // volume that is missing in the cells of all ranks, by material
  PairSumMap Rates;         // rates at which materials gain volume, of this rank
};

/// Marks the cells at interfaces.
PagedArray<unsigned char> MarkActive(const CartesianGrid& grid, const LabelArray& labels)
{
  PagedArray<unsigned char> isActive(grid, 0);
  for (Index node : FindMixedNodes(grid, labels))
  {
    for (int c = 0; c < 8; ++c)
    {
      isActive.Set(grid.CellOfNode(node, c), 1);
    }
  }
  return isActive;
}

/// Finds the cells at interfaces.
/// @param materials  number of labels
ActiveCells FindCells(const CartesianGrid& grid, const LabelArray& labels, std::size_t materials,
  const Partition& partition, Runtime& runtime)
{
  const double scale = 1.0 / Cube(grid.MeanWidth());
  const PagedArray<unsigned char> isActive = MarkActive(grid, labels);
  ActiveCells active{ partition.Group(), runtime };
  std::vector<ExactSum> totals(materials);
  partition.ForCells(grid.Owned(),
    [&](Index cell)
    {
      const Index3 p = grid.Position(cell);
      const double volume = grid.CellVolume(p) * scale;
      const int label = labels[cell];
      totals[label].Add(volume);
      if (isActive[cell])
      {
        active.Cells.push_back({ p, label, volume, LeastFloor, { { label, 1.0 } } });
      }
    });
  active.Totals = SumOverRanks(totals, active.Group);
  return active;
}

/// Returns the largest relative error of a volume.
double FindError(const std::vector<double>& lack, const std::vector<double>& totals)
{
  double worst = 0.0;
  for (std::size_t m = 0; m < lack.size(); ++m)
  {
    if (totals[m] > 0.0)
    {
      worst = std::max(worst, std::fabs(lack[m]) / totals[m]);
    }
  }
  return worst;
}

/// Calls body(cell, tally) for the active cells on several threads, which may change the fractions
/// and add rates.
template <class Body>
Balance Visit(ActiveCells& active, const Body& body)
{
  std::vector<ActiveCell>& cells = active.Cells;
  Tally sum(active.Totals.size());
  std::mutex mutex;
  active.Run.For(0, static_cast<Index>(cells.size()),
    [&](Index begin, Index end)
    {
      Tally mine(active.Totals.size());
      for (Index c = begin; c < end; ++c)
      {
        mine.Volumes[cells[c].Label].Add(-cells[c].Volume);
        body(cells[c], mine);
        mine.AddVolumes(cells[c]);
      }
      const std::lock_guard<std::mutex> lock(mutex);
      sum.Add(mine);
    });
  Balance balance{ SumOverRanks(sum.Volumes, active.Group), std::move(sum.Rates) };
  for (double& lack : balance.Lack)
  {
    lack = -lack;
  }
  return balance;
}

/// Returns the labels of a cell and of the 26 around it, ascending.
std::vector<int> LabelsAround(
  const CartesianGrid& grid, const LabelArray& labels, const Index3& cell)
{
  std::vector<int> found;
  for (int v = 0; v < 27; ++v)
  {
    found.push_back(labels[grid.Linear(CellAround(cell, v))]);
  }
  SortUnique(found);
  return found;
}

/// Sets the fractions and the floor of a cell.
/// @param patches  fields of the labels around it
void PartCell(const std::vector<MaterialPatch>& patches, ActiveCell& cell, Tally& tally)
{
  std::vector<PairRate> rates;
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

/// Returns a factor for each label that reduces its lack of volume.
std::vector<double> FindSteps(const Balance& balance, double largest, Ranks& ranks)
{
  std::vector<double> steps = SolveForLack(GatherPairSums(balance.Rates, ranks), balance.Lack);
  for (double& step : steps)
  {
    step = Exp(std::min(std::max(step, -largest), largest));
  }
  return steps;
}

/// Moves the interfaces until the volumes are nearly right.
Balance PartCells(const CartesianGrid& grid, const LabelArray& labels, const FractionField& smooth,
  ActiveCells& active)
{
  std::vector<double> weights(active.Totals.size(), 1.0); // factors of the fields
  for (int round = 1;; ++round)
  {
    Balance balance = Visit(active,
      [&](ActiveCell& cell, Tally& tally)
      {
        const std::vector<int> around = LabelsAround(grid, labels, cell.Position);
        PartCell(MakePatches(grid, smooth, cell.Position, around, weights), cell, tally);
      });
    if (FindError(balance.Lack, active.Totals) < WeightsAreGood || round == WeightRounds)
    {
      return balance;
    }
    const std::vector<double> steps = FindSteps(balance, LargestWeightStep, active.Group);
    for (std::size_t m = 0; m < steps.size(); ++m)
    {
      weights[m] *= steps[m];
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
void AddRates(const std::vector<double>& lack, const ActiveCell& cell, Tally& tally)
{
  const bool isHeld = OwnFraction(cell) <= cell.Floor && lack[cell.Label] <= 0.0;
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

/// Scales fractions until the volumes are right; returns the largest relative error.
/// @param lack  volumes that are missing before
double ScaleFractions(std::vector<double> lack, ActiveCells& active)
{
  std::vector<double> factors(lack.size(), 1.0);
  for (int round = 1;; ++round)
  {
    Balance balance = Visit(active,
      [&](ActiveCell& cell, Tally& tally)
      {
        ScaleCell(cell, factors);
        AddRates(lack, cell, tally);
      });
    const double error = FindError(balance.Lack, active.Totals);
    if (error < VolumesAreGood || round == ScaleRounds)
    {
      return error;
    }
    factors = FindSteps(balance, LargestScaleStep, active.Group);
    lack = std::move(balance.Lack);
  }
}

void Store(const CartesianGrid& grid, const std::vector<ActiveCell>& cells, FractionField& labels)
{
  for (const ActiveCell& cell : cells)
  {
    std::vector<Part> parts;
    for (const Part& part : cell.Parts)
    {
      if (part.Fraction > Negligible)
      {
        parts.push_back(part);
      }
    }
    labels.CopyParts(grid.Linear(cell.Position), parts);
  }
}

} // namespace

double SmoothLabels(const CartesianGrid& grid, int passes, const Partition& partition,
  Runtime& runtime, FractionField& labels)
{
  const LabelArray own = AssignMaterials(grid, labels, 0.5);
  ActiveCells active = FindCells(grid, own, labels.NumberOfMaterials() + 1, partition, runtime);
  Balance balance =
    PartCells(grid, own, AverageFractions(grid, labels, passes, partition, runtime), active);
  const double error = ScaleFractions(std::move(balance.Lack), active);
  Store(grid, active.Cells, labels);
  FillGhosts(partition, labels);
  return error;
}

std::string DescribeVolumeError(double error)
{
  std::ostringstream text;
  if (error > VolumeTolerance)
  {
    text << "Smoothing could not keep the volumes of all labels: the largest error is "
         << 100.0 * error << " %. Fewer passes, or MinimumRegionCells, may help.";
  }
  return text.str();
}

} // namespace vfm
