#include "State/ConserveState.h"

#include "Transfer/NodalVelocity.h"
#include "Transfer/Overlaps.h"

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

/// Of the components of what becomes of states.
std::vector<std::string> NamesFor(
  const ConservedArray& array, const std::vector<StateArray>& states)
{
  return array.IsVector ? std::vector<std::string>{ "X", "Y", "Z" }
                        : states[array.States[0]].ComponentNames;
}

/// What the elements of a mesh take, and what becomes of kinetic energy.
class StateConserver
{
public:
  StateConserver(const Mesh& mesh, const CartesianGrid& grid, const ConservedCells& cells,
    const InputContents& contents, const ConserveOptions& options, Runtime& runtime) :
    TheMesh(mesh),
    Grid(grid),
    Contents(contents),
    Plan(contents.GetPlan()),
    Options(options),
    Run(runtime)
  {
    TransferRequest request{ cells.GetGrid(), cells.GetFractions(), cells,
      ListQuantities(this->Plan), this->Plan.Density, options.StateOrder,
      options.UnmeshedMaterial == Unmeshed::Give };
    this->Taken = TransferState(mesh, request, runtime);
    if (this->Plan.Velocity >= 0)
    {
      this->FindLosses();
    }
  }

  ConservedState Make(const std::vector<StateArray>& states)
  {
    ConservedState result;
    result.Balance = this->FindBalance();
    for (std::size_t a = 0; a < this->Plan.Conserved.size(); ++a)
    {
      const ConservedArray& array = this->Plan.Conserved[a];
      if (array.Meaning == StateMeaning::Extensive)
      {
        this->MultiplyByVolume(array.Components, this->Taken.Values[a]);
      }
      result.States.push_back(array.States[0]);
      result.Arrays.push_back({ array.Name, ValueType::Double, array.Components,
        NamesFor(array, states), TakeBytes(this->Taken.Values[a]) });
    }
    if (this->HasNodes())
    {
      const ConservedArray& velocity = this->Plan.Conserved[this->Plan.Velocity];
      result.NodalVelocity = CarriedArray{ velocity.Name, ValueType::Double, 3,
        NamesFor(velocity, states), TakeBytes(this->Nodes.Velocity) };
    }
    return result;
  }

private:
  bool HasNodes() const { return this->Plan.Velocity >= 0 && this->Options.NodalVelocity; }

  const Buffer<double>& Velocity() const { return this->Taken.Values[this->Plan.Velocity]; }

  /// Collective.
  void FindLosses()
  {
    this->LostToElements = FindLostKineticEnergy(
      this->Taken.Mass, this->Velocity(), this->Taken.Values.back(), this->Run);
    if (this->HasNodes())
    {
      this->Nodes =
        FindNodalVelocity(this->TheMesh, this->Grid, this->Taken.Mass, this->Velocity(), this->Run);
    }
    if (this->Options.LostKineticEnergy == LostEnergy::InternalEnergy && this->Plan.Energy >= 0)
    {
      Buffer<double>& energy = this->Taken.Values[this->Plan.Energy];
      ForEach(this->Run, energy.size(),
        [&](Index e)
        {
          const double mass = this->Taken.Mass[e];
          const double lost =
            this->LostToElements[e] + (this->HasNodes() ? this->Nodes.Lost[e] : 0.0);
          energy[e] += mass > 0.0 ? lost / mass : 0.0;
        });
    }
  }

  void MultiplyByVolume(int components, Buffer<double>& values)
  {
    ForEach(this->Run, this->TheMesh.Material.size(),
      [&](Index e)
      {
        const double volume = VolumeOfElement(this->TheMesh, e);
        for (int c = 0; c < components; ++c)
        {
          values[components * e + c] *= volume;
        }
      });
  }

  StateSums SumsOfElement(Index e) const
  {
    StateSums sums;
    sums.Mass = this->Taken.Mass[e];
    if (this->Plan.Velocity >= 0)
    {
      const double* u = this->Velocity().data() + 3 * e;
      sums.Momentum = { { sums.Mass * u[0], sums.Mass * u[1], sums.Mass * u[2] } };
      sums.Kinetic = 0.5 * sums.Mass * (u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
      sums.LostToElements = this->LostToElements[e];
      sums.LostToNodes = this->HasNodes() ? this->Nodes.Lost[e] : 0.0;
    }
    if (this->Plan.Energy >= 0)
    {
      sums.Internal = sums.Mass * this->Taken.Values[this->Plan.Energy][e];
    }
    return sums;
  }

  /// From totals of the columns.
  StateSums SumsOfTotals(const StateTotals& totals) const
  {
    StateSums sums;
    sums.Volume = totals[0];
    sums.Mass = totals[1];
    const double* columns = totals.data() + 2;
    if (this->Plan.Velocity >= 0)
    {
      std::copy_n(
        columns + this->Contents.FirstColumn(this->Plan.Velocity), 3, sums.Momentum.begin());
      sums.Kinetic = totals.back();
    }
    if (this->Plan.Energy >= 0)
    {
      sums.Internal = columns[this->Contents.FirstColumn(this->Plan.Energy)];
    }
    return sums;
  }

  /// Collective.
  StateBalance FindBalance() const
  {
    StateBalance balance;
    balance.HasDensity = this->Plan.Density >= 0;
    balance.HasVelocity = this->Plan.Velocity >= 0;
    balance.HasEnergy = this->Plan.Energy >= 0;
    balance.HasNodes = this->HasNodes();
    balance.Factors = this->Taken.Factors;
    for (std::size_t m = 0; m < this->Taken.Input.size(); ++m)
    {
      balance.Input.push_back(this->SumsOfTotals(this->Taken.Input[m]));
      balance.Unmeshed.push_back(this->SumsOfTotals(this->Taken.Unmeshed[m]));
    }
    balance.Mesh = SumElements(
      this->TheMesh, static_cast<int>(this->Taken.Input.size()),
      [this](Index e) { return this->SumsOfElement(e); }, this->Run.Group());
    return balance;
  }

  const Mesh& TheMesh;
  const CartesianGrid& Grid;
  const InputContents& Contents;
  const StatePlan& Plan;
  const ConserveOptions& Options;
  Runtime& Run;
  TransferredState Taken;
  Buffer<double> LostToElements; // of each element
  NodalVelocity Nodes;
};

} // namespace

ConservedState ConserveState(const Mesh& mesh, const CartesianGrid& grid,
  const ConservedCells& cells, const InputContents& contents, const std::vector<StateArray>& states,
  const ConserveOptions& options, Runtime& runtime)
{
  return StateConserver(mesh, grid, cells, contents, options, runtime).Make(states);
}

} // namespace vfm
