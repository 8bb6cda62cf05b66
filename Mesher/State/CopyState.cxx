#include "State/CopyState.h"

#include "Ranks/Agreement.h"
#include "State/StateValues.h"
#include "Transfer/StateCells.h"

#include <cstring>

namespace vfm
{
namespace
{

/// Position of the values of an element.
struct StatePlace
{
  const StateBlock* Source;
  Index Place;
};

/// Finds the finest cell of the input at the centre of a cell of a level.
StatePlace FindPlace(const Index3& cell, int level, const StateValues& values)
{
  const int finest = static_cast<int>(values.size()) - 1;
  for (int l = finest; l >= 0; --l)
  {
    Index3 own = cell;
    for (Index& i : own)
    {
      i = l <= level ? i >> (level - l) : (2 * i + 1) << (l - level - 1);
    }
    if (const StateBlock* source = values[l]->Find(own))
    {
      return { source, source->Place(own) };
    }
  }
  throw InputError("A cell of the input has no state."); // the levels fill a box
}

/// Rotates the tuples of an array of reals of this type.
template <class Real>
void Rotate(const ImageFrame& frame, TransferredArray& array)
{
  const std::size_t size = array.Components * sizeof(Real);
  std::vector<Real> tuple(array.Components);
  std::vector<double> values(array.Components);
  for (char* at = array.Values.begin(); at < array.Values.end(); at += size)
  {
    std::memcpy(tuple.data(), at, size);
    std::copy(tuple.begin(), tuple.end(), values.begin());
    RotateTuple(frame, array.Components, values.data());
    std::transform(values.begin(), values.end(), tuple.begin(),
      [](double value) { return static_cast<Real>(value); });
    std::memcpy(at, tuple.data(), size);
  }
}

/// Makes the array of a state; number: its index; frame: axes of arrays that are rotated.
TransferredArray MakeOutput(const StateArray& state, std::size_t number,
  const std::vector<StatePlace>& places, const ImageFrame& frame)
{
  const std::size_t size = TupleSize(state);
  TransferredArray array{ state.Name, state.Type, state.Components, state.ComponentNames, false,
    Buffer<char>(places.size() * size) };
  char* to = array.Values.data();
  for (const StatePlace& place : places)
  {
    std::memcpy(to, place.Source->Values[number] + place.Place * size, size);
    to += size;
  }
  if (state.IsRotated)
  {
    state.Type == ValueType::Float ? Rotate<float>(frame, array) : Rotate<double>(frame, array);
  }
  return array;
}

} // namespace

std::vector<TransferredArray> CopyState(const InputLevels& input,
  const std::vector<StateArray>& states, const Mesh& mesh, const MeshedGrid& meshed,
  const std::vector<BlockPlace>& owners, Runtime& runtime)
{
  std::vector<TransferredArray> arrays;
  if (states.empty())
  {
    return arrays;
  }
  Ranks& ranks = runtime.Group();
  const StateValues values = ExchangeState(input, states, meshed.Level, owners, ranks);
  WorkTogether(ranks,
    [&]
    {
      std::vector<StatePlace> places;
      for (Index cell : FindStateCells(mesh, meshed.Grid, meshed.Fractions, runtime))
      {
        const Index3 whole = meshed.Division.ParentOf(CellInBox(meshed.Grid.Local(), cell));
        places.push_back(FindPlace(whole, meshed.Level, values));
      }
      for (std::size_t a = 0; a < states.size(); ++a)
      {
        arrays.push_back(MakeOutput(states[a], a, places, input.Reading.Frame));
      }
    });
  return arrays;
}

} // namespace vfm
