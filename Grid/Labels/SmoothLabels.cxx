#include "Labels/SmoothLabels.h"

#include "Base/PairSums.h"
#include "Base/PortableMath.h"
#include "Fractions/AverageFractions.h"
#include "Fractions/FractionsAround.h"
#include "Fractions/GhostFractions.h"
#include "Fractions/SharpFractions.h"
#include "Labels/Labels.h"

#include <cmath>
#include <mutex>
#include <span>
#include <sstream>

namespace vfm
{
namespace
{

using Part = FractionField::Part;

constexpr double LeastFloor = 0.501;     // least fraction of the own label of a cell
constexpr double VolumeTolerance = 1e-6; // relative error of volumes without a warning
constexpr int WeightRounds = 5;          // rounds that move the interfaces
constexpr double WeightsAreGood = 1e-4;  // relative error of volumes at which they end
constexpr double LargestWeightStep = 0.3;
constexpr int ScaleRounds = 60; // rounds that scale the fractions
constexpr double VolumesAreGood = 1e-9;
constexpr double LargestScaleStep = 1.0;
constexpr double Negligible = 1e-9;       // smaller fractions count as 0
constexpr double LeadMargin = 1.0 + 1e-6; // above the rounding of leads

/// Cell that may become mixed.
struct ActiveCell
{
  Index3 Position;
  int Label;
  int NumberOfParts;     // labels of the cell and of the 26 around it
  std::size_t FirstPart; // in ActiveCells::Parts
  double Volume;         // in volumes of a mean cell
  double Floor;          // least fraction of its label
};

/// Volumes by material, and the rates at which materials gain volume from each other.
class Tally
{
public:
  explicit Tally(std::size_t materials) : Volumes(materials) {}
  void AddRate(int first, int second, double rate)
  {
    const std::pair<int, int> key = std::minmax(first, second);
    if (key != this->LastKey)
    {
      this->LastKey = key;
      this->LastRate = &this->Rates[key];
    }
    this->LastRate->Add(rate);
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

  std::vector<ExactSum> Volumes;
  PairSumMap Rates;

private:
  std::pair<int, int> LastKey{ -1, -1 }; // adjacent cells mostly have rates of one pair
  ExactSum* LastRate = nullptr;
};

/// Cells of this rank that may become mixed, and the volumes of all labels.
struct ActiveCells
{
  Ranks& Group;
  Runtime& Run;
  std::vector<ActiveCell> Cells{};
  std::vector<Part> Parts{};    // of all cells, each ascending by material; fractions may be 0
  std::vector<float> Leads{};   // of the own label of the cell over the label of each part
  std::vector<double> Totals{}; // volumes of the labels over all ranks, in mean cells

  std::span<Part> PartsOf(const ActiveCell& cell)
  {
    return { this->Parts.data() + cell.FirstPart, static_cast<std::size_t>(cell.NumberOfParts) };
  }
};

Part& OwnPart(const ActiveCell& cell, std::span<Part> parts)
{
  return *std::find_if(
    parts.begin(), parts.end(), [&](const Part& part) { return part.Material == cell.Label; });
}

bool HasAll(const ActiveCell& cell, std::span<const Part> parts)
{
  return std::all_of(parts.begin(), parts.end(),
    [&](const Part& part) { return part.Fraction == (part.Material == cell.Label ? 1.0 : 0.0); });
}

/// Raises the own label of a cell to its floor, if it has less, and scales the others to the rest.
/// @return whether it had less
bool RaiseOwn(const ActiveCell& cell, std::span<Part> parts)
{
  const double own = OwnPart(cell, parts).Fraction;
  if (own >= cell.Floor)
  {
    return false;
  }
  const double scale = (1.0 - cell.Floor) / (1.0 - own);
  for (Part& part : parts)
  {
    part.Fraction = part.Material == cell.Label ? cell.Floor : part.Fraction * scale;
  }
  return true;
}

/// Returns the floor of a cell. The weaker its label is at its centre, the thinner is the part to
/// which it belongs, and the more of the cell it keeps. A single cell stays nearly full.
double FindFloor(const ActiveCell& cell, const std::vector<MaterialPatch>& patches)
{
  double own = 0.0, other = 0.0;
  for (const MaterialPatch& patch : patches)
  {
    const double value = patch.Values[MaterialPatch::Middle];
    (patch.Material == cell.Label ? own : other) =
      patch.Material == cell.Label ? value : std::max(other, value);
  }
  return std::max(LeastFloor, other / (own + other));
}

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

/// Lists the labels of a cell and of the 26 around it, ascending.
void ListLabelsAround(
  const CartesianGrid& grid, const LabelArray& labels, Index cell, std::vector<int>& found)
{
  found.clear();
  for (int row = 0; row < 9; ++row)
  {
    const Index first = cell + (row % 3 - 1) * grid.Stride(1) + (row / 3 - 1) * grid.Stride(2) - 1;
    const LabelArray::RowView view = labels.Row(first);
    const Index i = labels.InRow(first);
    for (Index step = 0; step < 3; ++step)
    {
      const int label = view[i + step];
      if (std::find(found.begin(), found.end(), label) == found.end())
      {
        found.push_back(label);
      }
    }
  }
  std::sort(found.begin(), found.end());
}

/// Adds the volumes of the cells of a row, by label.
/// @param row  position of its first cell
/// @param scale  1 over the volume of a mean cell
void AddVolumes(const CartesianGrid& grid, const LabelArray& labels, const Index3& row,
  double scale, std::vector<ExactSum>& totals)
{
  const Index first = grid.Linear(row), last = first + grid.Owned().Size(0);
  const auto addRun = [&](Index begin, Index end, int label)
  {
    double volume = 0.0;
    Index count = 0; // cells of this volume
    for (Index cell = begin; cell < end; ++cell)
    {
      const double next = grid.CellVolume({ { row[0] + cell - first, row[1], row[2] } }) * scale;
      if (next != volume)
      {
        totals[label].Add(volume, count);
        volume = next;
        count = 0;
      }
      ++count;
    }
    totals[label].Add(volume, count);
  };
  labels.Visit(first, last, addRun,
    [&](Index begin, Index end, const int* values)
    {
      for (Index cell = begin; cell < end; ++cell)
      {
        addRun(cell, cell + 1, values[cell - begin]);
      }
    });
}

/// Adds the cells of a row that are marked.
/// @param row  position of its first cell
/// @param scale  1 over the volume of a mean cell
void AddActive(const CartesianGrid& grid, const LabelArray& labels,
  const PagedArray<unsigned char>& isActive, const Index3& row, double scale, ActiveCells& active)
{
  const Index first = grid.Linear(row), last = first + grid.Owned().Size(0);
  std::vector<int> around;
  const auto add = [&](Index cell)
  {
    const Index3 p{ { row[0] + cell - first, row[1], row[2] } };
    ListLabelsAround(grid, labels, cell, around);
    active.Cells.push_back({ p, labels[cell], static_cast<int>(around.size()), active.Parts.size(),
      grid.CellVolume(p) * scale, LeastFloor });
    for (int label : around)
    {
      active.Parts.push_back({ label, 0.0 });
    }
  };
  const auto addMarked = [&](Index begin, Index end, const auto& isMarked)
  {
    for (Index cell = begin; cell < end; ++cell)
    {
      if (isMarked(cell - begin))
      {
        add(cell);
      }
    }
  };
  isActive.Visit(
    first, last,
    [&](Index begin, Index end, unsigned char mark)
    { addMarked(begin, mark ? end : begin, [](Index) { return true; }); },
    [&](Index begin, Index end, const unsigned char* marks)
    { addMarked(begin, end, [&](Index c) { return marks[c] != 0; }); });
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
  ForRows(grid.Owned(),
    [&](Index j, Index k)
    {
      const Index3 row{ { grid.Owned().Lower[0], j, k } };
      AddVolumes(grid, labels, row, scale, totals);
      AddActive(grid, labels, isActive, row, scale, active);
    });
  active.Totals = SumOverRanks(totals, active.Group);
  return active;
}

/// Returns the linear indices of the active cells.
std::vector<Index> ListPlaces(const CartesianGrid& grid, const ActiveCells& active)
{
  std::vector<Index> places;
  places.reserve(active.Cells.size());
  for (const ActiveCell& cell : active.Cells)
  {
    places.push_back(grid.Linear(cell.Position));
  }
  return places;
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

/// Changes the parts of the active cells on several threads.
/// @param makeBody  makeBody() returns the body of a range of cells, which is called as
///   body(c, cell, parts, tally). It may change the parts and the floor of cell c, and add rates
template <class MakeBody>
Balance Visit(ActiveCells& active, const MakeBody& makeBody)
{
  Tally sum(active.Totals.size());
  std::mutex mutex;
  active.Run.For(0, static_cast<Index>(active.Cells.size()),
    [&](Index begin, Index end)
    {
      Tally mine(active.Totals.size());
      auto body = makeBody();
      for (Index c = begin; c < end; ++c)
      {
        ActiveCell& cell = active.Cells[c];
        const std::span<Part> parts = active.PartsOf(cell);
        body(c, cell, parts, mine);
        if (!HasAll(cell, parts)) // else it lacks nothing
        {
          mine.Volumes[cell.Label].Add(-cell.Volume);
          for (const Part& part : parts)
          {
            mine.Volumes[part.Material].Add(part.Fraction * cell.Volume);
          }
        }
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

/// Finds the fractions and the floors of cells; keeps its memory, for the next cell.
class CellDivider
{
public:
  /// @param weights  factors of the fields
  /// @param round  from 1; the first has weights 1 and finds the leads, which later rounds read
  /// @param leads  ActiveCells::Leads
  CellDivider(const CartesianGrid& grid, const FractionsAround& smooth,
    const std::vector<double>& weights, int round, std::vector<float>& leads) :
    Smooth(smooth),
    Weights(weights),
    Round(round),
    Leads(leads),
    Patches(grid, static_cast<int>(weights.size()) - 1)
  {
  }

  /// A label with a smaller field than the own label everywhere in the cell is left out. It would
  /// not even change the floor.
  void operator()(Index c, ActiveCell& cell, std::span<Part> parts, Tally& tally)
  {
    float* const leads = this->Leads.data() + cell.FirstPart;
    this->Around.clear();
    for (std::size_t p = 0; p < parts.size(); ++p)
    {
      const int label = parts[p].Material;
      parts[p].Fraction = label == cell.Label ? 1.0 : 0.0;
      if (label == cell.Label ||
        !(leads[p] * this->Weights[cell.Label] > LeadMargin * this->Weights[label]))
      {
        this->Around.push_back(label);
      }
    }
    if (this->Around.size() == 1)
    {
      return;
    }
    const std::vector<MaterialPatch>& patches = this->Patches.Find(cell.Position, this->Around,
      this->Weights, [&](const auto& visit) { this->Smooth.ForParts(c, visit); });
    this->Divide(patches, parts);
    if (this->Round == 1)
    {
      FindLeads(patches, cell.Label, leads);
    }
    cell.Floor = FindFloor(cell, patches);
    if (!RaiseOwn(cell, parts))
    {
      for (const PairRate& rate : this->Rates)
      {
        tally.AddRate(rate.First, rate.Second, rate.Rate * cell.Volume);
      }
    }
  }

private:
  void Divide(const std::vector<MaterialPatch>& patches, std::span<Part> parts)
  {
    this->Rates.clear();
    const std::vector<double>& fractions =
      this->Sharp.Find(patches, this->Round < WeightRounds ? &this->Rates : nullptr);
    auto part = parts.begin();
    for (std::size_t p = 0; p < patches.size(); ++p)
    {
      while (part->Material != patches[p].Material)
      {
        ++part;
      }
      part->Fraction = fractions[p];
    }
  }
  static void FindLeads(const std::vector<MaterialPatch>& patches, int label, float* leads)
  {
    const auto own = std::find_if(patches.begin(), patches.end(),
      [&](const MaterialPatch& patch) { return patch.Material == label; });
    for (const MaterialPatch& patch : patches)
    {
      *leads++ = static_cast<float>(FindLead(*own, patch));
    }
  }

  const FractionsAround& Smooth;
  const std::vector<double>& Weights;
  const int Round;
  std::vector<float>& Leads;
  PatchFinder Patches;
  std::vector<int> Around; // labels
  SharpFractions Sharp;
  std::vector<PairRate> Rates;
};

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
Balance PartCells(const CartesianGrid& grid, const FractionsAround& smooth, ActiveCells& active)
{
  std::vector<double> weights(active.Totals.size(), 1.0); // factors of the fields
  active.Leads.assign(active.Parts.size(), 0.0f);
  for (int round = 1;; ++round)
  {
    const bool isLast = round == WeightRounds;
    Balance balance =
      Visit(active, [&] { return CellDivider(grid, smooth, weights, round, active.Leads); });
    if (isLast || FindError(balance.Lack, active.Totals) < WeightsAreGood)
    {
      active.Leads = std::vector<float>();
      return balance;
    }
    const std::vector<double> steps = FindSteps(balance, LargestWeightStep, active.Group);
    for (std::size_t m = 0; m < steps.size(); ++m)
    {
      weights[m] *= steps[m];
    }
  }
}

void ScaleCell(const ActiveCell& cell, const std::vector<double>& factors, std::span<Part> parts)
{
  double sum = 0.0;
  for (Part& part : parts)
  {
    part.Fraction *= factors[part.Material];
    sum += part.Fraction;
  }
  for (Part& part : parts)
  {
    part.Fraction /= sum;
  }
  RaiseOwn(cell, parts);
}

/// Adds the rates at which the materials of a cell gain from each other when they are scaled. A
/// label at its floor loses nothing.
void AddRates(
  const std::vector<double>& lack, const ActiveCell& cell, std::span<Part> parts, Tally& tally)
{
  const bool isHeld = OwnPart(cell, parts).Fraction <= cell.Floor && lack[cell.Label] <= 0.0;
  for (auto a = parts.begin(); a != parts.end(); ++a)
  {
    for (auto b = a + 1; b != parts.end(); ++b)
    {
      const double product = a->Fraction * b->Fraction;
      if (a->Fraction > 0.0 && b->Fraction > 0.0 &&
        (!isHeld || (a->Material != cell.Label && b->Material != cell.Label)))
      {
        tally.AddRate(a->Material, b->Material, product * cell.Volume);
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
      [&]
      {
        return [&](Index, const ActiveCell& cell, std::span<Part> parts, Tally& tally)
        {
          ScaleCell(cell, factors, parts);
          AddRates(lack, cell, parts, tally);
        };
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

/// Leaves out cells that are full of their label, which scaling does not change.
void LeaveOutFull(ActiveCells& active)
{
  std::vector<ActiveCell>& cells = active.Cells;
  cells.erase(std::remove_if(cells.begin(), cells.end(),
                [&](const ActiveCell& cell) { return HasAll(cell, active.PartsOf(cell)); }),
    cells.end());
}

void Store(const CartesianGrid& grid, ActiveCells& active, FractionField& labels)
{
  std::vector<Part> parts;
  for (const ActiveCell& cell : active.Cells)
  {
    parts.clear();
    for (const Part& part : active.PartsOf(cell))
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
  ActiveCells active = FindCells(
    grid, AssignMaterials(grid, labels, 0.5), labels.NumberOfMaterials() + 1, partition, runtime);
  Balance balance = PartCells(grid,
    FractionsAround(
      grid, AverageFractions(grid, labels, passes, partition, runtime), ListPlaces(grid, active)),
    active);
  LeaveOutFull(active);
  const double error = ScaleFractions(std::move(balance.Lack), active);
  Store(grid, active, labels);
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
