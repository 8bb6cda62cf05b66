#include "State/StateArrays.h"

#include "Input/InputArrays.h"
#include "Input/PackBytes.h"
#include "Ranks/Agreement.h"

#include <functional>

namespace vfm
{
namespace
{

constexpr const char* ArraysOfMesh[] = { "MaterialId", "FragmentId", "GlobalCellIds",
  "ScaledJacobian", "vtkGhostType" };

StateArray Describe(const InputBlock& block, const std::string& name)
{
  const auto array = FindTuples(block, name);
  return { name, array->Type, array->Components, array->ComponentNames };
}

std::string Text(const StateArray& state)
{
  return std::to_string(state.Components) + " component" + (state.Components == 1 ? "" : "s") +
    " of type " + NameOfType(state.Type);
}

void CheckAgainst(const StateArray& expected, const InputBlock& block)
{
  const StateArray state = Describe(block, expected.Name);
  if (state.Type != expected.Type || state.Components != expected.Components)
  {
    throw InputError(block.Name + ": the state array '" + state.Name + "' has " + Text(state) +
      ", but in other blocks it has " + Text(expected) + ".");
  }
}

Bytes Pack(const std::vector<StateArray>& states)
{
  Packer packer;
  for (const StateArray& state : states)
  {
    packer.Add(state.Type);
    packer.Add(state.Components);
    packer.Add(state.ComponentNames);
  }
  return std::move(packer.Packed);
}

std::vector<StateArray> Unpack(const Bytes& bytes, const std::vector<std::string>& names)
{
  Unpacker unpacker(bytes);
  std::vector<StateArray> states;
  for (const std::string& name : names)
  {
    states.push_back({ name, unpacker.Take<int>(), unpacker.Take<int>(), {} });
    unpacker.TakeTo(states.back().ComponentNames);
  }
  return states;
}

/// Collective. Returns the list of the lowest rank that has any.
std::vector<StateArray> AgreeOn(
  const std::vector<StateArray>& mine, const std::vector<std::string>& names, Ranks& ranks)
{
  const int rank = mine.empty() ? ranks.Count() : ranks.Rank();
  const bool isFirst = -ranks.Max(-rank) == ranks.Rank();
  for (const Bytes& message : ranks.Gather(isFirst ? Pack(mine) : Bytes()))
  {
    if (!message.empty())
    {
      return Unpack(message, names);
    }
  }
  return {};
}

/// Calls visit(block) for each block of this rank.
void VisitBlocks(const InputLevels& input, const std::function<void(const InputBlock&)>& visit)
{
  for (const InputBlocks& level : input.Levels)
  {
    for (const InputBlock& block : level.Blocks)
    {
      visit(block);
    }
  }
}

} // namespace

void CheckNameOfState(const std::string& name)
{
  if (std::find(std::begin(ArraysOfMesh), std::end(ArraysOfMesh), name) != std::end(ArraysOfMesh))
  {
    throw InputError("The state array '" + name +
      "' has the name of an array that the mesh itself may have: rename it, or leave it "
      "out.");
  }
}

std::vector<StateArray> FindStateArrays(
  const InputLevels& input, const std::vector<std::string>& names, Ranks& ranks)
{
  if (names.empty())
  {
    return {};
  }
  std::vector<StateArray> mine;
  WorkTogether(ranks,
    [&]
    {
      std::for_each(names.begin(), names.end(), CheckNameOfState);
      VisitBlocks(input,
        [&](const InputBlock& block)
        {
          for (const std::string& name : names)
          {
            mine.push_back(Describe(block, name));
          }
        });
    });
  mine.resize(std::min(mine.size(), names.size())); // arrays of the first block
  const std::vector<StateArray> states = AgreeOn(mine, names, ranks);
  WorkTogether(ranks,
    [&]
    {
      VisitBlocks(input,
        [&](const InputBlock& block)
        {
          for (const StateArray& state : states)
          {
            CheckAgainst(state, block);
          }
        });
    });
  return states;
}

int CarrierType(int type)
{
  return type == ValueType::Bit ? ValueType::UnsignedChar : type;
}

std::size_t TupleSize(const StateArray& array)
{
  return static_cast<std::size_t>(array.Components * WidthOfType(CarrierType(array.Type)));
}

} // namespace vfm
