#include "State/CarryState.h"

#include <map>
#include <numeric>

namespace vfm
{

StateCarrier::StateCarrier(const InputLevels& input, StateChoice choice, Ranks& ranks) :
  Input(input),
  Choice(std::move(choice)),
  States(FindStateArrays(input, this->Choice.Arrays, ranks))
{
}

void StateCarrier::Keep(const LevelCells& cells, const LevelFields& fields, const LevelSetup& setup,
  bool meshVoid, const std::vector<BlockPlace>& owners, Runtime& runtime)
{
  if (!this->Choice.IsConserved)
  {
    this->Plan.Copied.resize(this->States.size());
    std::iota(this->Plan.Copied.begin(), this->Plan.Copied.end(), 0);
    return;
  }
  this->Plan = PlanState(this->Choice, this->States, fields.Field.Table);
  if (!this->Plan.Conserved.empty())
  {
    this->Contents = std::make_unique<InputContents>(this->States, this->Plan);
    this->Kept = std::make_unique<ConservedCells>(this->Input, cells, this->States, *this->Contents,
      fields, std::min(setup.Finest, this->Input.Finest()), meshVoid, owners, runtime);
  }
}

CarriedState StateCarrier::Carry(const Mesh& mesh, const MeshedGrid& meshed,
  const ConserveOptions& options, const std::vector<BlockPlace>& owners, Runtime& runtime) const
{
  CarriedState carried;
  std::vector<StateArray> copied;
  for (std::size_t s : this->Plan.Copied)
  {
    copied.push_back(this->States[s]);
  }
  std::map<std::size_t, CarriedArray> arrays; // by the first state of each
  auto copies = CopyState(this->Input, copied, mesh, meshed, owners, runtime);
  for (std::size_t c = 0; c < copies.size(); ++c)
  {
    arrays[this->Plan.Copied[c]] = std::move(copies[c]);
  }
  if (this->Kept)
  {
    ConservedState conserved = ConserveState(
      mesh, meshed.Grid, *this->Kept, *this->Contents, this->States, options, runtime);
    for (std::size_t a = 0; a < conserved.Arrays.size(); ++a)
    {
      arrays[conserved.States[a]] = std::move(conserved.Arrays[a]);
    }
    carried.NodalVelocity = std::move(conserved.NodalVelocity);
    carried.Balance = std::move(conserved.Balance);
    carried.IsConserved = true;
  }
  for (auto& array : arrays)
  {
    carried.Arrays.push_back(std::move(array.second));
  }
  return carried;
}

} // namespace vfm
