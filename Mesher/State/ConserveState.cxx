#include "State/ConserveState.h"

#include "State/RepeatedCells.h"
#include "State/Transfer/NodalVelocity.h"
#include "State/Transfer/Overlaps.h"

namespace vfm
{
namespace
{

std::vector<StateQuantity> ListQuantities(const StatePlan& plan)
{
  std::vector<StateQuantity> quantities;
  for (const ConservedArray& array : plan.Conserved)
  {
    const bool isPerMass = array.Meaning == StateMeaning::PerMass;
    quantities.push_back(
      { isPerMass ? StateKind::PerMass : StateKind::PerVolume, array.Components, array.Weight });
  }
  if (plan.Velocity >= 0)
  {
    quantities.push_back({ StateKind::PerMass, 1, -1 }); // |u|^2 / 2
  }
  return quantities;
}

/// Returns the names of the components of an output array.
std::vector<std::string> NamesFor(
  const ConservedArray& array, const std::vector<StateArray>& states)
{
  return array.IsVector ? std::vector<std::string>{ "X", "Y", "Z" }
                        : states[array.States[0]].ComponentNames;
}

/// State of the elements, and lost kinetic energy.
struct GivenState
{
  TransferredState Taken;
  Buffer<double> LostToElements; ///< lost kinetic energy of each element, if there is a velocity
  NodalVelocity Nodes;
  bool HasNodes; ///< true if the points of the mesh get a velocity
};

/// Adds the lost kinetic energy to the internal energy.
void AddLostEnergy(const StatePlan& plan, Runtime& runtime, GivenState& given)
{
  Buffer<double>& energy = given.Taken.Values[plan.Energy];
  ForEach(runtime, energy.size(),
    [&](Index e)
    {
      const double mass = given.Taken.Mass[e];
      const double lost = given.LostToElements[e] + (given.HasNodes ? given.Nodes.Lost[e] : 0.0);
      energy[e] += mass > 0.0 ? lost / mass : 0.0;
    });
}

/// Collective. Transfers the state and finds the lost kinetic energy.
GivenState Transfer(const Mesh& mesh, const CartesianGrid& grid, const ConservedCells& cells,
  const ConserveOptions& options, Runtime& runtime)
{
  const StatePlan& plan = cells.GetContents().GetPlan();
  const RepeatedCells repeated(cells, grid, runtime.Group());
  const TransferRequest request{ repeated.GetGrid(), repeated.GetFractions(), repeated,
    ListQuantities(plan), plan.Density, options.StateOrder,
    options.UnmeshedMaterial == Unmeshed::Give };
  GivenState given{ TransferState(mesh, request, runtime), {}, {},
    plan.Velocity >= 0 && options.NodalVelocity };
  if (plan.Velocity < 0)
  {
    return given;
  }
  const TransferredState& taken = given.Taken;
  const Buffer<double>& velocity = taken.Values[plan.Velocity];
  given.LostToElements = FindLostKineticEnergy(taken.Mass, velocity, taken.Values.back(), runtime);
  if (given.HasNodes)
  {
    given.Nodes = FindNodalVelocity(mesh, grid, taken.Mass, velocity, runtime);
  }
  if (options.LostKineticEnergy == LostEnergy::InternalEnergy && plan.Energy >= 0)
  {
    AddLostEnergy(plan, runtime, given);
  }
  return given;
}

StateSums SumsOfElement(const StatePlan& plan, const GivenState& given, Index e)
{
  StateSums sums;
  sums.Mass = given.Taken.Mass[e];
  if (plan.Velocity >= 0)
  {
    const double* u = given.Taken.Values[plan.Velocity].data() + 3 * e;
    sums.Momentum = { { sums.Mass * u[0], sums.Mass * u[1], sums.Mass * u[2] } };
    sums.Kinetic = 0.5 * sums.Mass * (u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
    sums.LostToElements = given.LostToElements[e];
    sums.LostToNodes = given.HasNodes ? given.Nodes.Lost[e] : 0.0;
  }
  if (plan.Energy >= 0)
  {
    sums.Internal = sums.Mass * given.Taken.Values[plan.Energy][e];
  }
  return sums;
}

/// Converts the totals of a material.
StateSums SumsOfTotals(const InputContents& contents, const StateTotals& totals)
{
  const StatePlan& plan = contents.GetPlan();
  StateSums sums;
  sums.Volume = totals[0];
  sums.Mass = totals[1];
  const double* columns = totals.data() + 2;
  if (plan.Velocity >= 0)
  {
    std::copy_n(columns + contents.FirstColumn(plan.Velocity), 3, sums.Momentum.begin());
    sums.Kinetic = totals.back();
  }
  if (plan.Energy >= 0)
  {
    sums.Internal = columns[contents.FirstColumn(plan.Energy)];
  }
  return sums;
}

/// Collective. Sums the state of the input, the mesh and unmeshed material.
StateBalance FindBalance(
  const Mesh& mesh, const InputContents& contents, const GivenState& given, Ranks& ranks)
{
  const StatePlan& plan = contents.GetPlan();
  StateBalance balance;
  balance.HasDensity = plan.Density >= 0;
  balance.HasVelocity = plan.Velocity >= 0;
  balance.HasEnergy = plan.Energy >= 0;
  balance.HasNodes = given.HasNodes;
  balance.Factors = given.Taken.Factors;
  for (std::size_t m = 0; m < given.Taken.Input.size(); ++m)
  {
    balance.Input.push_back(SumsOfTotals(contents, given.Taken.Input[m]));
    balance.Unmeshed.push_back(SumsOfTotals(contents, given.Taken.Unmeshed[m]));
  }
  balance.Mesh = SumElements(
    mesh, static_cast<int>(given.Taken.Input.size()),
    [&](Index e) { return SumsOfElement(plan, given, e); }, ranks);
  return balance;
}

void MultiplyByVolume(const Mesh& mesh, int components, Buffer<double>& values, Runtime& runtime)
{
  ForEach(runtime, mesh.Material.size(),
    [&](Index e)
    {
      const double volume = VolumeOfElement(mesh, e);
      for (int c = 0; c < components; ++c)
      {
        values[components * e + c] *= volume;
      }
    });
}

TransferredArray MakeArray(
  const ConservedArray& array, const std::vector<StateArray>& states, Buffer<double>& values)
{
  return { array.Name, ValueType::Double, array.Components, NamesFor(array, states),
    array.Meaning == StateMeaning::Extensive, TakeBytes(values) };
}

} // namespace

ConservedState ConserveState(const Mesh& mesh, const CartesianGrid& grid,
  const ConservedCells& cells, const ConserveOptions& options, Runtime& runtime)
{
  const InputContents& contents = cells.GetContents();
  const StatePlan& plan = contents.GetPlan();
  const std::vector<StateArray>& states = contents.GetStates();
  GivenState given = Transfer(mesh, grid, cells, options, runtime);
  ConservedState result;
  result.Balance = FindBalance(mesh, contents, given, runtime.Group());
  for (std::size_t a = 0; a < plan.Conserved.size(); ++a)
  {
    const ConservedArray& array = plan.Conserved[a];
    Buffer<double>& values = given.Taken.Values[a];
    if (array.Meaning == StateMeaning::Extensive)
    {
      MultiplyByVolume(mesh, array.Components, values, runtime);
    }
    result.States.push_back(array.States[0]);
    result.Arrays.push_back(MakeArray(array, states, values));
  }
  if (given.HasNodes)
  {
    result.NodalVelocity = MakeArray(plan.Conserved[plan.Velocity], states, given.Nodes.Velocity);
  }
  return result;
}

} // namespace vfm
