#include "State/MeshState.h"

#include "Ranks/Agreement.h"
#include "State/ConservedCells.h"
#include "State/RotatedArrays.h"
#include "State/WideContents.h"

#include <map>
#include <numeric>

namespace vfm
{
namespace
{

/// Returns the plan that copies all states.
StatePlan PlanCopies(std::size_t states)
{
  StatePlan plan;
  plan.Copied.resize(states);
  std::iota(plan.Copied.begin(), plan.Copied.end(), 0);
  return plan;
}

} // namespace

bool NeedsState(const StateChoice& choice, const MesherOptions& options)
{
  return !choice.Arrays.empty() || options.UnmeshedMaterial == Unmeshed::Particles;
}

StoredState StoreState(const InputLevels& input, const LevelCells& cells, const StateChoice& choice,
  std::vector<StateArray> states, const LevelFields& fields, const LevelSetup& setup,
  const MesherOptions& options, const std::vector<BlockPlace>& owners, Runtime& runtime)
{
  StatePlan plan =
    choice.IsConserved ? PlanState(choice, states, fields.Field.Table) : PlanCopies(states.size());
  if (!options.ImageAxes)
  {
    MarkRotated(choice.Rotated, plan, states);
  }
  StoredState kept;
  kept.Places = plan.Copied;
  for (std::size_t s : kept.Places)
  {
    kept.Copied.push_back(states[s]);
  }
  const bool hasParticles = options.UnmeshedMaterial == Unmeshed::Particles;
  if (!plan.Conserved.empty() || hasParticles)
  {
    if (plan.Conserved.empty())
    {
      states.clear();
    }
    kept.Conserved = std::make_unique<ConservedCells>(input, cells,
      InputContents(states, std::move(plan), input.Reading.Frame), fields,
      std::min(setup.Finest, input.Finest()), options.MeshVoid, owners, runtime);
  }
  return kept;
}

void WidenState(const CartesianGrid& grid, Runtime& runtime, StoredState& kept)
{
  if (kept.Conserved)
  {
    WorkTogether(runtime.Group(),
      [&] { kept.Conserved = std::make_unique<WideContents>(*kept.Conserved, grid, runtime); });
  }
}

namespace
{

/// Arrays by the first state that they are made of.
using ArraysByState = std::map<std::size_t, TransferredArray>;

/// Places arrays; moves them.
void Place(const std::vector<std::size_t>& states, std::vector<TransferredArray>& arrays,
  ArraysByState& placed)
{
  for (std::size_t a = 0; a < arrays.size(); ++a)
  {
    placed[states[a]] = std::move(arrays[a]);
  }
}

std::vector<TransferredArray> InOrder(ArraysByState& placed)
{
  std::vector<TransferredArray> arrays;
  for (auto& array : placed)
  {
    arrays.push_back(std::move(array.second));
  }
  return arrays;
}

/// Adds the copied arrays to particles. Collective.
Particles CompleteParticles(const StoredState& kept, const std::vector<std::size_t>& conserved,
  ConservedParticles made, const InputLevels& input, const std::vector<BlockPlace>& owners,
  Ranks& ranks)
{
  const bool isWide = !kept.InputNodes[0].empty();
  for (Index3& cell : made.Cells)
  {
    cell = isWide ? CellAtCentre(kept.Conserved->GetGrid(), cell, kept.InputNodes) : cell;
  }
  std::vector<TransferredArray> copies = CopyCells(input, kept.Copied, made.Cells,
    isWide ? input.Finest() : kept.Conserved->GetLevel(), owners, ranks);
  ArraysByState arrays;
  Place(conserved, made.Items.Arrays, arrays);
  Place(kept.Places, copies, arrays);
  made.Items.Arrays = InOrder(arrays);
  return std::move(made.Items);
}

} // namespace

OutputState MakeOutputState(const StoredState& kept, const InputLevels& input, const Mesh& mesh,
  MeshedGrid meshed, const ConserveOptions& options, const std::vector<BlockPlace>& owners,
  Runtime& runtime)
{
  OutputState transferred;
  ArraysByState arrays;
  meshed.InputNodes = kept.InputNodes[0].empty() ? nullptr : &kept.InputNodes;
  auto copies = CopyState(input, kept.Copied, mesh, meshed, owners, runtime);
  Place(kept.Places, copies, arrays);
  if (kept.Conserved)
  {
    ConservedState conserved = ConserveState(mesh, meshed, *kept.Conserved, options, runtime);
    Place(conserved.States, conserved.Arrays, arrays);
    if (conserved.TheParticles)
    {
      transferred.TheParticles = CompleteParticles(
        kept, conserved.States, std::move(*conserved.TheParticles), input, owners, runtime.Group());
    }
    transferred.NodalVelocity = std::move(conserved.NodalVelocity);
    transferred.Balance = std::move(conserved.Balance);
    transferred.IsConserved = true;
  }
  transferred.Arrays = InOrder(arrays);
  return transferred;
}

} // namespace vfm
