#include "State/CopyState.h"

#include "Base/Partition.h"
#include "Ranks/Agreement.h"
#include "State/StateValues.h"
#include "State/Transfer/StateCells.h"

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
StatePlace FindInLevels(const Index3& cell, int level, const StateValues& values)
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

/// Finds the cell of the input of a cell of the domain.
StatePlace FindPlace(const Index3& cell, const MeshedGrid& meshed, const StateValues& values)
{
  if (meshed.InputNodes)
  {
    return FindInLevels(CellAtCentre(meshed.Grid, cell, *meshed.InputNodes),
      static_cast<int>(values.size()) - 1, values);
  }
  Index3 own = cell;
  for (int a = 0; a < 3; ++a)
  {
    own[a] -= meshed.Grid.Domain().Lower[a];
  }
  return FindInLevels(meshed.Division.ParentOf(own), meshed.Level, values);
}

/// The values in copies of cells around a periodic domain, which the owners of the cells send.
class CopiedCells
{
public:
  explicit CopiedCells(const Partition& partition) :
    Parts(partition), Keys(partition.Peers().size()), Blocks(partition.Peers().size())
  {
  }

  /// Requests the values of a copy. The place is valid after Receive().
  StatePlace Request(const Index3& cell)
  {
    const int peer = this->Parts.PeerOfCell(cell);
    this->Keys[peer].push_back(this->Parts.CellKeyAtPeer(peer, cell));
    return { &this->Blocks[peer], static_cast<Index>(this->Keys[peer].size()) - 1 };
  }

  /// Receives the requested values. Collective among peers.
  void Receive(
    const std::vector<StateArray>& states, const MeshedGrid& meshed, const StateValues& values)
  {
    std::vector<Bytes> answers;
    for (const std::vector<Index>& keys : this->Parts.Exchange(this->Keys))
    {
      answers.push_back(Pack(keys, states, meshed, values));
    }
    this->Received = this->Parts.Exchange(answers);
    for (std::size_t peer = 0; peer < this->Blocks.size(); ++peer)
    {
      const char* next = this->Received[peer].data();
      for (const StateArray& state : states)
      {
        this->Blocks[peer].Values.push_back(next);
        next += TupleSize(state) * this->Keys[peer].size();
      }
    }
  }

private:
  /// Returns the values in some cells, array by array.
  static Bytes Pack(const std::vector<Index>& keys, const std::vector<StateArray>& states,
    const MeshedGrid& meshed, const StateValues& values)
  {
    Bytes bytes;
    for (std::size_t a = 0; a < states.size(); ++a)
    {
      for (Index key : keys)
      {
        const std::size_t size = TupleSize(states[a]);
        const StatePlace place = FindPlace(meshed.Grid.CellOfKey(key), meshed, values);
        const char* tuple = place.Source->Values[a] + place.Place * size;
        bytes.insert(bytes.end(), tuple, tuple + size);
      }
    }
    return bytes;
  }

  const Partition& Parts;
  std::vector<std::vector<Index>> Keys; // keys of the requested cells on each peer
  std::vector<StateBlock> Blocks;       // values from each peer, in the order of its keys
  std::vector<Bytes> Received;
};

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

Index3 CellAtCentre(
  const CartesianGrid& grid, const Index3& cell, const std::array<std::vector<double>, 3>& nodes)
{
  Index3 at;
  for (int a = 0; a < 3; ++a)
  {
    const double centre = 0.5 * (grid.Coordinates(a)[cell[a]] + grid.Coordinates(a)[cell[a] + 1]);
    at[a] = std::upper_bound(nodes[a].begin(), nodes[a].end(), centre) - nodes[a].begin() - 1;
  }
  return at;
}

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
  const Partition partition(meshed.Grid, ranks);
  std::vector<StatePlace> places;
  CopiedCells copied(partition);
  WorkTogether(ranks,
    [&]
    {
      for (Index at : FindStateCells(mesh, meshed.Grid, meshed.Fractions, runtime))
      {
        const Index3 cell = CellInBox(meshed.Grid.Local(), at);
        const bool isCopy = !meshed.Grid.Domain().Contains(cell);
        places.push_back(isCopy ? copied.Request(cell) : FindPlace(cell, meshed, values));
      }
    });
  if (meshed.Grid.IsPeriodic())
  {
    copied.Receive(states, meshed, values);
  }
  WorkTogether(ranks,
    [&]
    {
      for (std::size_t a = 0; a < states.size(); ++a)
      {
        arrays.push_back(MakeOutput(states[a], a, places, input.Reading.Frame));
      }
    });
  return arrays;
}

std::vector<TransferredArray> CopyCells(const InputLevels& input,
  const std::vector<StateArray>& states, const std::vector<Index3>& cells, int level,
  const std::vector<BlockPlace>& owners, Ranks& ranks)
{
  std::vector<TransferredArray> arrays;
  if (states.empty())
  {
    return arrays;
  }
  const StateValues values = ExchangeState(input, states, level, owners, ranks);
  WorkTogether(ranks,
    [&]
    {
      std::vector<StatePlace> places;
      for (const Index3& cell : cells)
      {
        places.push_back(FindInLevels(cell, level, values));
      }
      for (std::size_t a = 0; a < states.size(); ++a)
      {
        arrays.push_back(MakeOutput(states[a], a, places, input.Reading.Frame));
      }
    });
  return arrays;
}

} // namespace vfm
