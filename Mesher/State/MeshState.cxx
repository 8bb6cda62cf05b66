#include "State/MeshState.h"

#include "State/RotatedArrays.h"

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
  if (!plan.Conserved.empty())
  {
    kept.Conserved = std::make_unique<ConservedCells>(input, cells,
      InputContents(states, std::move(plan), input.Reading.Frame), fields,
      std::min(setup.Finest, input.Finest()), options.MeshVoid, owners, runtime);
  }
  return kept;
}

OutputState MakeOutputState(const StoredState& kept, const InputLevels& input, const Mesh& mesh,
  const MeshedGrid& meshed, const ConserveOptions& options, const std::vector<BlockPlace>& owners,
  Runtime& runtime)
{
  OutputState transferred;
  std::map<std::size_t, TransferredArray> arrays; // key: first state of an array
  auto copies = CopyState(input, kept.Copied, mesh, meshed, owners, runtime);
  for (std::size_t c = 0; c < copies.size(); ++c)
  {
    arrays[kept.Places[c]] = std::move(copies[c]);
  }
  if (kept.Conserved)
  {
    ConservedState conserved = ConserveState(mesh, meshed.Grid, *kept.Conserved, options, runtime);
    for (std::size_t a = 0; a < conserved.Arrays.size(); ++a)
    {
      arrays[conserved.States[a]] = std::move(conserved.Arrays[a]);
    }
    transferred.NodalVelocity = std::move(conserved.NodalVelocity);
    transferred.Balance = std::move(conserved.Balance);
    transferred.IsConserved = true;
  }
  for (auto& array : arrays)
  {
    transferred.Arrays.push_back(std::move(array.second));
  }
  return transferred;
}

} // namespace vfm
