#include "State/MeshState.h"

#include <map>
#include <numeric>

namespace vfm
{

StoredState StoreState(const InputLevels& input, const LevelCells& cells, const StateChoice& choice,
  const std::vector<StateArray>& states, const LevelFields& fields, const LevelSetup& setup,
  bool meshVoid, const std::vector<BlockPlace>& owners, Runtime& runtime)
{
  StoredState kept;
  if (!choice.IsConserved)
  {
    kept.Copied = states;
    kept.Places.resize(states.size());
    std::iota(kept.Places.begin(), kept.Places.end(), 0);
    return kept;
  }
  StatePlan plan = PlanState(choice, states, fields.Field.Table);
  kept.Places = plan.Copied;
  for (std::size_t s : kept.Places)
  {
    kept.Copied.push_back(states[s]);
  }
  if (!plan.Conserved.empty())
  {
    kept.Conserved =
      std::make_unique<ConservedCells>(input, cells, InputContents(states, std::move(plan)), fields,
        std::min(setup.Finest, input.Finest()), meshVoid, owners, runtime);
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
