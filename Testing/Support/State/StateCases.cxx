#include "State/StateCases.h"

#include "State/Transfer/Overlaps.h"

#include "Base/Vector3.h"

#include <cmath>
#include <numeric>
#include <sstream>

namespace vfm
{
namespace testing
{
namespace
{

StateOutcome MakeOutcome(
  const StateCase& c, const CartesianGrid& grid, const FractionField& fractions, Runtime& runtime)
{
  MeshReport report;
  const Mesh mesh = c.Make(grid, fractions, c.Options, runtime, report);
  const FunctionValues values(c, grid);
  const TransferredState state = TransferState(
    mesh, { grid, fractions, values, c.Quantities, c.Density, c.Order, c.GiveUnmeshed }, runtime);
  StateOutcome outcome{ {}, state.Input, state.Unmeshed, state.Factors };
  std::vector<Index> all(mesh.ElementIds.size());
  std::iota(all.begin(), all.end(), Index(0));
  const CartesianGrid box({ { { grid.Coordinates(0).front(), grid.Coordinates(0).back() },
    { grid.Coordinates(1).front(), grid.Coordinates(1).back() },
    { grid.Coordinates(2).front(), grid.Coordinates(2).back() } } });
  const Overlaps whole = FindOverlaps(mesh, all, box, runtime);
  for (std::size_t e = 0; e < mesh.ElementIds.size(); ++e)
  {
    ElementOutcome element{ mesh.Material[e], mesh.Fragment[e],
      VolumeOfElement(mesh, static_cast<Index>(e)), state.Mass[e], {}, {},
      { { 1e300, 1e300, 1e300 } }, { { -1e300, -1e300, -1e300 } }, {} };
    for (int k = 0; k < mesh.Corners; ++k)
    {
      const double* x = mesh.Points.data() + 3 * mesh.Elements[mesh.Corners * e + k];
      element.Centroid = element.Centroid + 1.0 / mesh.Corners * Vector3{ { x[0], x[1], x[2] } };
      for (int a = 0; a < 3; ++a)
      {
        element.Lower[a] = std::min(element.Lower[a], x[a]);
        element.Upper[a] = std::max(element.Upper[a], x[a]);
      }
    }
    for (std::size_t q = 0; q < c.Quantities.size(); ++q)
    {
      const int n = c.Quantities[q].Components;
      const double* own = state.Values[q].data() + n * e;
      element.Values.insert(element.Values.end(), own, own + n);
    }
    element.Mean = whole.Parts[whole.Offsets[e]].Centroid;
    outcome.Elements.emplace(mesh.ElementIds[e], std::move(element));
  }
  return outcome;
}

} // namespace

StateOutcome TransferAlone(const StateCase& c)
{
  Runtime alone;
  return MakeOutcome(c, c.Grid, c.Fractions, alone);
}

StateOutcome TransferOnThreads(const StateCase& c)
{
  ThreadedRuntime threads;
  return MakeOutcome(c, c.Grid, c.Fractions, threads);
}

StateOutcome TransferOnRanks(const StateCase& c, const std::vector<IndexBox>& boxes)
{
  const GridLayers layers = LayersFor(c.Options.Levels);
  std::vector<StateOutcome> outcomes(boxes.size());
  RunOnRanks(static_cast<int>(boxes.size()),
    [&](Ranks& ranks)
    {
      const CartesianGrid grid = MakeRankGrid(c.Grid, boxes[ranks.Rank()], layers);
      RankRuntime runtime(ranks);
      outcomes[ranks.Rank()] =
        MakeOutcome(c, grid, CopyToLocal(c.Grid, c.Fractions, grid), runtime);
    });
  StateOutcome all = outcomes[0];
  for (const StateOutcome& outcome : outcomes)
  {
    all.Elements.insert(outcome.Elements.begin(), outcome.Elements.end());
    if (outcome.Input != all.Input || outcome.Unmeshed != all.Unmeshed ||
      outcome.Factors != all.Factors)
    {
      all.Input.clear(); // differs from any other result
    }
  }
  return all;
}

namespace
{

/// Conserved sums from element values, and sums of magnitudes.
struct Contents
{
  std::vector<std::vector<long double>> Sums, Sizes; // by material
};

Contents SumContents(const StateCase& c, const StateOutcome& outcome)
{
  std::size_t width = 2;
  for (const StateQuantity& quantity : c.Quantities)
  {
    width += quantity.Components;
  }
  const std::size_t materials = c.Fractions.NumberOfMaterials() + 1;
  Contents contents;
  contents.Sums.assign(materials, std::vector<long double>(width, 0.0L));
  contents.Sizes = contents.Sums;
  const auto firstOf = [&](int quantity)
  {
    std::size_t first = 0;
    for (int q = 0; q < quantity; ++q)
    {
      first += c.Quantities[q].Components;
    }
    return first;
  };
  for (const auto& entry : outcome.Elements)
  {
    const ElementOutcome& e = entry.second;
    const auto add = [&](std::size_t column, long double value)
    {
      contents.Sums[e.Material][column] += value;
      contents.Sizes[e.Material][column] += std::fabs(value);
    };
    const double mass = c.Density < 0 ? e.Mass : e.Volume * e.Values[firstOf(c.Density)];
    add(0, e.Volume);
    add(1, mass);
    std::size_t column = 0;
    for (const StateQuantity& quantity : c.Quantities)
    {
      const double weight = quantity.Kind == StateKind::PerVolume ? e.Volume
        : quantity.Weight < 0                                     ? mass
                              : mass * e.Values[firstOf(quantity.Weight)];
      for (int i = 0; i < quantity.Components; ++i, ++column)
      {
        add(2 + column, weight * e.Values[column]);
      }
    }
  }
  return contents;
}

} // namespace

std::vector<StateTotals> SumElements(const StateCase& c, const StateOutcome& outcome)
{
  std::vector<StateTotals> totals;
  for (const std::vector<long double>& sums : SumContents(c, outcome).Sums)
  {
    totals.emplace_back(sums.begin(), sums.end());
  }
  return totals;
}

std::string FindTotalsProblem(const StateCase& c, const StateOutcome& outcome, double tolerance)
{
  const Contents contents = SumContents(c, outcome);
  for (std::size_t m = 0; m < contents.Sums.size(); ++m)
  {
    for (std::size_t i = 1; i < contents.Sums[m].size(); ++i)
    {
      const long double input = outcome.Input[m][i];
      const long double made = contents.Sums[m][i] + outcome.Unmeshed[m][i];
      const long double size =
        std::max({ contents.Sizes[m][i], std::fabs(input), std::fabs(made) });
      if (!(std::fabs(made - input) <= tolerance * size))
      {
        std::ostringstream text;
        text << "material " << m << ", total " << i << ": off by " << (made - input) / size
             << " of " << size << ". ";
        return text.str();
      }
    }
  }
  return "";
}

std::string FindOutcomeDifference(const StateOutcome& a, const StateOutcome& b)
{
  std::size_t differences = a.Elements.size() == b.Elements.size() ? 0 : 1;
  for (const auto& entry : a.Elements)
  {
    const auto at = b.Elements.find(entry.first);
    differences += at == b.Elements.end() || at->second.Values != entry.second.Values ||
      at->second.Mass != entry.second.Mass;
  }
  std::string text = differences > 0 ? std::to_string(differences) + " of " +
      std::to_string(a.Elements.size()) + " elements differ. "
                                     : "";
  text += a.Input == b.Input ? "" : "Other totals of the input. ";
  text += a.Unmeshed == b.Unmeshed ? "" : "Other totals of unmeshed content. ";
  return text + (a.Factors == b.Factors ? "" : "Other factors.");
}

std::array<double, 6> SumUp(const std::vector<StateSums>& one, const std::vector<StateSums>& other)
{
  std::array<double, 6> sums{};
  for (const std::vector<StateSums>* all : { &one, &other })
  {
    for (const StateSums& s : *all)
    {
      const double own[6] = { s.Mass, s.Momentum[0], s.Momentum[1], s.Momentum[2], s.Internal,
        s.Kinetic + s.LostToElements };
      std::transform(sums.begin(), sums.end(), own, sums.begin(), std::plus<>());
    }
  }
  return sums;
}

std::vector<StateQuantity> MakeCodeQuantities()
{
  return { { StateKind::PerVolume, 1, -1 }, { StateKind::PerMass, 3, -1 },
    { StateKind::PerMass, 1, -1 }, { StateKind::PerMass, 1, -1 }, { StateKind::PerMass, 1, 3 },
    { StateKind::PerVolume, 6, -1 }, { StateKind::PerVolume, 1, -1 } };
}

} // namespace testing
} // namespace vfm
