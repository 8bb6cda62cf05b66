#include "MesherCall.h"

#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

namespace vfm
{
namespace
{

namespace nb = nanobind;

/// Sets a value if the dict has a key with a name.
template <class Value>
void Read(const nb::dict& from, const char* name, Value& value)
{
  if (from.contains(name))
  {
    value = nb::cast<Value>(from[name]);
  }
}

Index CountCells(const std::array<std::vector<double>, 3>& coordinates)
{
  Index count = 1;
  for (const std::vector<double>& x : coordinates)
  {
    count *= static_cast<Index>(x.size()) - 1;
  }
  return count;
}

InputBlock MakeBlock(const MesherCall& call, const Ranks& ranks)
{
  InputBlock block;
  block.ArePoints = call.ArePoints;
  block.Coordinates = call.Coordinates;
  FinishBlock(block, -1, ranks);
  block.Arrays = MakeBlockArrays(CountCells(call.Coordinates), call.Arrays);
  return block;
}

} // namespace

StateChoice ReadStateChoice(nb::handle state, TransferMode transfer)
{
  StateChoice choice;
  if (!state.is_none())
  {
    const auto from = nb::cast<nb::dict>(state);
    Read(from, "arrays", choice.Arrays);
    Read(from, "densities", choice.Densities);
    Read(from, "kinds", choice.Kinds);
    Read(from, "velocity", choice.Velocity);
    Read(from, "energy", choice.Energy);
    Read(from, "rotated", choice.Rotated);
    choice.IsConserved = ConservesState(transfer, choice.Densities);
  }
  return choice;
}

MesherInput MakeInput(const MesherCall& call, Runtime& runtime)
{
  CollectedBlocks collected;
  collected.Blocks =
    call.Blocks.empty() ? std::vector<InputBlock>{ MakeBlock(call, runtime.Group()) } : call.Blocks;
  collected.Reading.ArePoints = call.ArePoints;
  collected.Reading.Frame = MakeImageFrame(call.Axes, call.Origin, "The input");
  MesherInput input;
  input.Arrays = { call.Fractions, call.Labels, call.Names,
    CompleteChoice(call.State, ArrayLists{ collected.Blocks[0].Arrays }, runtime.Group()),
    call.AreGuessed, false, call.LabelsOption };
  input.Surfaces = call.Surfaces;
  input.Levels = FindInputLevels(std::move(collected), runtime.Group());
  return input;
}

} // namespace vfm
