#include "State/ConserveState.h"

#include "State/RepeatedCells.h"
#include "State/Transfer/NodalVelocity.h"
#include "State/Transfer/Overlaps.h"

#include <tuple>

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

/// State of the elements, and lost kinetic energy.
struct GivenState
{
  TransferredState Taken;
  Buffer<double> LostToElements; ///< lost kinetic energy of each element, if there is a velocity
  NodalVelocity Nodes;
  bool HasNodes; ///< true if the points of the mesh get a velocity
  std::optional<ConservedParticles> TheParticles;
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

/// Returns the volumes of far material in the cells of a grid of a level of the input, which are
/// cells of the mesh or larger.
std::vector<FarVolume> FindFarVolumes(
  const std::vector<FarMatter>& far, const MeshedGrid& meshed, int level, const CartesianGrid& grid)
{
  std::vector<FarVolume> volumes;
  for (const FarMatter& part : far)
  {
    Index3 cell = meshed.Grid.CellOfKey(part.Cell);
    for (int a = 0; a < 3; ++a)
    {
      cell[a] -= meshed.Grid.Domain().Lower[a];
    }
    cell = ChangeLevel(BoxOfCell(meshed.Division.ParentOf(cell)), level - meshed.Level).Lower;
    for (int a = 0; a < 3; ++a)
    {
      cell[a] += grid.Domain().Lower[a];
    }
    volumes.push_back({ grid.Linear(cell), part.Material, part.Volume });
  }
  const auto isSame = [](const FarVolume& a, const FarVolume& b)
  { return a.Cell == b.Cell && a.Material == b.Material; };
  std::stable_sort(volumes.begin(), volumes.end(),
    [](const FarVolume& a, const FarVolume& b)
    { return std::tie(a.Cell, a.Material) < std::tie(b.Cell, b.Material); });
  std::vector<FarVolume> sums;
  for (const FarVolume& volume : volumes)
  {
    if (sums.empty() || !isSame(sums.back(), volume))
    {
      sums.push_back(volume);
      continue;
    }
    sums.back().Volume += volume.Volume;
  }
  return sums;
}

/// Collective. Transfers the state and finds the lost kinetic energy.
GivenState Transfer(const Mesh& mesh, const MeshedGrid& meshed, const DonorCells& cells,
  const ConserveOptions& options, Runtime& runtime)
{
  const StatePlan& plan = cells.GetContents().GetPlan();
  const RepeatedCells repeated(cells, meshed.Grid, runtime.Group());
  const CartesianGrid& grid = repeated.GetGrid();
  const bool hasParticles = options.UnmeshedMaterial == Unmeshed::Particles;
  const ParticleRequest particles{ FindFarVolumes(mesh.Far, meshed, cells.GetLevel(), grid),
    options.ParticleClusters, options.LeastParticle };
  const TransferRequest request{ grid, repeated.GetFractions(), repeated, ListQuantities(plan),
    plan.Density, plan.Conserved.empty() ? 1 : options.StateOrder,
    options.UnmeshedMaterial != Unmeshed::Drop, hasParticles ? &particles : nullptr };
  GivenState given{ TransferState(mesh, request, runtime), {}, {},
    plan.Velocity >= 0 && options.NodalVelocity, {} };
  if (hasParticles)
  {
    given.TheParticles = MakeParticles(given.Taken.Particles, grid, cells, options, runtime);
  }
  if (plan.Velocity < 0)
  {
    return given;
  }
  const TransferredState& taken = given.Taken;
  const Buffer<double>& velocity = taken.Values[plan.Velocity];
  given.LostToElements = FindLostKineticEnergy(taken.Mass, velocity, taken.Values.back(), runtime);
  if (given.HasNodes)
  {
    given.Nodes = FindNodalVelocity(mesh, meshed.Grid, taken.Mass, velocity, runtime);
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
  balance.Mesh = SumByMaterial(
    mesh.Material.data(), mesh.Material.size(), static_cast<int>(given.Taken.Input.size()),
    [&](Index e) { return SumsOfElement(plan, given, e); }, ranks);
  if (given.TheParticles)
  {
    balance.Particles = given.TheParticles->Sums;
    balance.ParticleCounts = given.TheParticles->Counts;
  }
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

} // namespace

ConservedState ConserveState(const Mesh& mesh, const MeshedGrid& meshed, const DonorCells& cells,
  const ConserveOptions& options, Runtime& runtime)
{
  const InputContents& contents = cells.GetContents();
  const StatePlan& plan = contents.GetPlan();
  GivenState given = Transfer(mesh, meshed, cells, options, runtime);
  ConservedState result;
  result.Balance = FindBalance(mesh, contents, given, runtime.Group());
  result.TheParticles = std::move(given.TheParticles);
  for (std::size_t a = 0; a < plan.Conserved.size(); ++a)
  {
    const ConservedArray& array = plan.Conserved[a];
    Buffer<double>& values = given.Taken.Values[a];
    if (array.Meaning == StateMeaning::Extensive)
    {
      MultiplyByVolume(mesh, array.Components, values, runtime);
    }
    result.States.push_back(array.States[0]);
    result.Arrays.push_back(contents.MakeArray(a, values));
  }
  if (given.HasNodes)
  {
    result.NodalVelocity = contents.MakeArray(plan.Velocity, given.Nodes.Velocity);
  }
  return result;
}

} // namespace vfm
