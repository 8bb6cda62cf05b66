/**
 * StateCarrier: carries state arrays of the input over to the mesh, copied or conserved as chosen.
 */
#pragma once

#include "State/ConserveState.h"
#include "State/CopyState.h"

namespace vfm
{

struct CarriedState
{
  std::vector<CarriedArray> Arrays;          ///< a tuple an element, in the order of the choice
  std::optional<CarriedArray> NodalVelocity; ///< a tuple a point
  bool IsConserved = false;                  ///< any, so that there is a balance
  StateBalance Balance;
};

class StateCarrier
{
public:
  /// Collective. Throws InputError, on all ranks alike, as FindStateArrays does. input must outlive this.
  StateCarrier(const InputLevels& input, StateChoice choice, Ranks& ranks);

  /// Collective: keeps what cells hold if anything is conserved. fields: as MakeLevelFields made them; setup: their levels; cells: of
  /// the input, to outlive this; owners: the cells of level 0 that the ranks mesh. Throws InputError, on all ranks alike, as PlanState and
  /// ConservedCells do.
  void Keep(const LevelCells& cells, const LevelFields& fields, const LevelSetup& setup,
    bool meshVoid, const std::vector<BlockPlace>& owners, Runtime& runtime);

  /// Collective. mesh: of this rank's owned cells, in the axes of the input.
  CarriedState Carry(const Mesh& mesh, const MeshedGrid& meshed, const ConserveOptions& options,
    const std::vector<BlockPlace>& owners, Runtime& runtime) const;

private:
  const InputLevels& Input;
  const StateChoice Choice;
  const std::vector<StateArray> States;
  StatePlan Plan;
  std::unique_ptr<InputContents> Contents;
  std::unique_ptr<ConservedCells> Kept;
};

} // namespace vfm
