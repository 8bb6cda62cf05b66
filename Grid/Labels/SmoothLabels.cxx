#include "Labels/SmoothLabels.h"

#include "Base/PairSums.h"
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

constexpr double LeastFloor = 0.501; // of a cell's own label
constexpr int MiddleOfPatch = 13;
constexpr int WeightRounds = 5;         // of moving the interfaces
constexpr double WeightsAreGood = 1e-4; // relative error of a volume that ends them
constexpr double LargestWeightStep = 0.3;
constexpr int ScaleRounds = 60; // of scaling the fractions
constexpr double VolumesAreGood = 1e-9;
constexpr double LargestScaleStep = 1.0;
constexpr double Negligible = 1e-9; // fractions below are none

/// A cell that may become mixed.
struct ActiveCell
{
  Index3 Position;
  int Label;
  double Volume;           // mean cells
  double Floor;            // the least fraction of its label
  std::vector<Part> Parts; // in the order of their materials
};

/// Volumes by material and what they would gain of each other.
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

class LabelSmoother
{
public:
  LabelSmoother(const CartesianGrid& grid, const FractionField& labels, const Partition& partition,
    Runtime& runtime);

  /// Moves the interfaces until the volumes are nearly right.
  void PartCells(const FractionField& smooth);
  /// Scales fractions until they are.
  void ScaleFractions();
  /// Largest relative error of a volume.
  double Error() const;
  void Store(FractionField& labels) const;

private:
  template <class Body>
  void Visit(const Body& body);
  std::vector<int> LabelsAround(const Index3& cell) const;
  void PartCell(const FractionField& smooth, ActiveCell& cell, Tally& tally) const;
  void ScaleCell(ActiveCell& cell, const std::vector<double>& factors) const;
  void AddRates(const ActiveCell& cell, Tally& tally) const;
  std::vector<double> FindSteps(double largest);

  const CartesianGrid& Grid;
  const Partition& Parts;
  Runtime& Run;
  LabelArray Labels;
  std::vector<ActiveCell> Cells;
  std::vector<double> Totals;  // of the labels, by material, mean cells
  std::vector<double> Lack;    // what the cells hold less
  std::vector<double> Weights; // of the fields, by material
  Tally Last;
};

LabelSmoother::LabelSmoother(const CartesianGrid& grid, const FractionField& labels,
  const Partition& partition, Runtime& runtime) :
  Grid(grid),
  Parts(partition),
  Run(runtime),
  Labels(AssignMaterials(grid, labels, 0.5)),
  Lack(labels.NumberOfMaterials() + 1, 0.0),
  Weights(this->Lack.size(), 1.0),
  Last(this->Lack.size())
{
  const double scale = std::pow(grid.MeanWidth(), -3.0);
  PagedArray<unsigned char> isActive(grid, 0);
  for (Index node : FindMixedNodes(grid, this->Labels))
  {
    for (int c = 0; c < 8; ++c)
    {
      isActive.Set(grid.CellOfNode(node, c), 1);
    }
  }
  std::vector<ExactSum> totals(this->Lack.size());
  partition.ForCells(grid.Owned(),
    [&](Index cell)
    {
      const Index3 p = grid.Position(cell);
      const double volume = grid.CellVolume(p) * scale;
      const int label = this->Labels[cell];
      totals[label].Add(volume);
      if (isActive[cell])
      {
        this->Cells.push_back({ p, label, volume, LeastFloor, { { label, 1.0 } } });
      }
    });
  this->Totals = SumOverRanks(totals, partition.Group());
}

/// Calls body(cell, tally) for the active cells, by several threads, and sets Last and Lack.
template <class Body>
void LabelSmoother::Visit(const Body& body)
{
  Tally sum(this->Lack.size());
  std::mutex mutex;
  this->Run.For(0, static_cast<Index>(this->Cells.size()),
    [&](Index begin, Index end)
    {
      Tally mine(this->Lack.size());
      for (Index c = begin; c < end; ++c)
      {
        mine.Volumes[this->Cells[c].Label].Add(-this->Cells[c].Volume);
        body(this->Cells[c], mine);
        mine.AddVolumes(this->Cells[c]);
      }
      const std::lock_guard<std::mutex> lock(mutex);
      sum.Add(mine);
    });
  this->Last = std::move(sum);
  this->Lack = SumOverRanks(this->Last.Volumes, this->Parts.Group());
  for (double& lack : this->Lack)
  {
    lack = -lack;
  }
}

/// The labels of a cell and of the 26 around it, ascending.
std::vector<int> LabelSmoother::LabelsAround(const Index3& cell) const
{
  std::vector<int> found;
  for (int v = 0; v < 27; ++v)
  {
    found.push_back(this->Labels[this->Grid.Linear(CellAround(cell, v))]);
  }
  SortUnique(found);
  return found;
}

double OwnFraction(const ActiveCell& cell)
{
  return FractionField::FractionOf(cell.Parts, cell.Label);
}

/// A cell's own label gets its floor, the others in proportion what is left.
void RaiseOwn(ActiveCell& cell)
{
  const double scale = (1.0 - cell.Floor) / (1.0 - OwnFraction(cell));
  PartOf(cell.Parts, cell.Label);
  for (Part& part : cell.Parts)
  {
    part.Fraction = part.Material == cell.Label ? cell.Floor : part.Fraction * scale;
  }
}

/// The weaker the label of a cell is in its own middle, the thinner is the part to which it belongs, and the more of the cell it
/// keeps: a single cell stays nearly whole.
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

void LabelSmoother::PartCell(const FractionField& smooth, ActiveCell& cell, Tally& tally) const
{
  std::vector<PairRate> rates;
  const std::vector<MaterialPatch> patches = MakePatches(
    this->Grid, smooth, cell.Position, this->LabelsAround(cell.Position), this->Weights);
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

std::vector<double> LabelSmoother::FindSteps(double largest)
{
  std::vector<double> steps =
    SolveForLack(GatherPairSums(this->Last.Rates, this->Parts.Group()), this->Lack);
  for (double& step : steps)
  {
    step = std::exp(std::min(std::max(step, -largest), largest));
  }
  return steps;
}

void LabelSmoother::PartCells(const FractionField& smooth)
{
  for (int round = 0; round < WeightRounds; ++round)
  {
    this->Visit([&](ActiveCell& cell, Tally& tally) { this->PartCell(smooth, cell, tally); });
    if (this->Error() < WeightsAreGood || round + 1 == WeightRounds)
    {
      break;
    }
    const std::vector<double> steps = this->FindSteps(LargestWeightStep);
    for (std::size_t m = 0; m < steps.size(); ++m)
    {
      this->Weights[m] *= steps[m];
    }
  }
}

void LabelSmoother::ScaleCell(ActiveCell& cell, const std::vector<double>& factors) const
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

/// What the materials of a cell gain of each other when they are scaled. A label at its floor goes no lower.
void LabelSmoother::AddRates(const ActiveCell& cell, Tally& tally) const
{
  const bool isHeld = OwnFraction(cell) <= cell.Floor && this->Lack[cell.Label] <= 0.0;
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

void LabelSmoother::ScaleFractions()
{
  std::vector<double> factors(this->Lack.size(), 1.0);
  for (int round = 0; round < ScaleRounds; ++round)
  {
    this->Visit(
      [&](ActiveCell& cell, Tally& tally)
      {
        this->ScaleCell(cell, factors);
        this->AddRates(cell, tally);
      });
    if (this->Error() < VolumesAreGood)
    {
      break;
    }
    factors = this->FindSteps(LargestScaleStep);
  }
}

double LabelSmoother::Error() const
{
  double worst = 0.0;
  for (std::size_t m = 0; m < this->Lack.size(); ++m)
  {
    if (this->Totals[m] > 0.0)
    {
      worst = std::max(worst, std::fabs(this->Lack[m]) / this->Totals[m]);
    }
  }
  return worst;
}

void LabelSmoother::Store(FractionField& labels) const
{
  for (const ActiveCell& cell : this->Cells)
  {
    std::vector<Part> parts;
    for (const Part& part : cell.Parts)
    {
      if (part.Fraction > Negligible)
      {
        parts.push_back(part);
      }
    }
    labels.CopyParts(this->Grid.Linear(cell.Position), parts);
  }
}

} // namespace

double SmoothLabels(const CartesianGrid& grid, int passes, const Partition& partition,
  Runtime& runtime, FractionField& labels)
{
  LabelSmoother smoother(grid, labels, partition, runtime);
  smoother.PartCells(AverageFractions(grid, labels, passes, partition, runtime));
  smoother.ScaleFractions();
  smoother.Store(labels);
  FillGhosts(partition, labels);
  return smoother.Error();
}

} // namespace vfm
