#include "State/StateValues.h"

#include "Input/InputArrays.h"
#include "Input/InputRoute.h"
#include "Ranks/Agreement.h"

namespace vfm
{

PlainTuples::PlainTuples(
  std::shared_ptr<const BlockArray> array, Index first, Index count, std::size_t size) :
  Array(std::move(array))
{
  if (this->Array->Memory)
  {
    this->Values = static_cast<const char*>(this->Array->Memory) + first * size;
    return;
  }
  this->Copy.resize(count * size);
  this->Array->Copy(first, count, this->Copy.data());
}

void LevelValues::Exchange(const std::vector<BlockPlace>& owners, Index ghostLayers, Ranks& ranks)
{
  const InputRoute route = FindInputRoute(owners, this->Input, ranks.Rank(), ghostLayers);
  std::vector<Bytes> outgoing;
  WorkTogether(ranks,
    [&]
    {
      this->AddBlocks();
      for (const IndexBox& requested : route.Requested)
      {
        outgoing.push_back(this->Pack(requested));
      }
    });
  this->Messages = ranks.Exchange(route.Peers, outgoing);
  for (const Bytes& message : this->Messages)
  {
    this->AddParts(message);
  }
}

const StateBlock* LevelValues::Find(const Index3& cell)
{
  if (this->Last < this->Sources.size() && this->Sources[this->Last].Box.Contains(cell))
  {
    return &this->Sources[this->Last];
  }
  const auto found = std::find_if(this->Sources.begin(), this->Sources.end(),
    [&cell](const StateBlock& source) { return source.Box.Contains(cell); });
  this->Last = found - this->Sources.begin();
  return found == this->Sources.end() ? nullptr : &*found;
}

void LevelValues::AddBlocks()
{
  for (const InputBlock& block : this->Input.Blocks)
  {
    StateBlock source;
    source.Box = block.Box;
    for (int a = 0; a < 3; ++a)
    {
      source.Stored.Lower[a] = block.Box.Lower[a] - block.Kept.Lower[a];
      source.Stored.Upper[a] = source.Stored.Lower[a] + block.Dimensions[a];
    }
    for (const StateArray& state : this->States)
    {
      this->Tuples.emplace_back(FindTuples(block, state.Name), block.FirstCell,
        source.Stored.NumberOfCells(), TupleSize(state));
      source.Values.push_back(this->Tuples.back().Data());
    }
    this->Sources.push_back(std::move(source));
  }
}

/// Packs the requested cells: for each block a box, then its values, array by array.
Bytes LevelValues::Pack(const IndexBox& requested) const
{
  Bytes message;
  for (const StateBlock& source : this->Sources)
  {
    const IndexBox box = Intersect(source.Box, requested);
    if (box.NumberOfCells() == 0)
    {
      continue;
    }
    const char* first = reinterpret_cast<const char*>(&box);
    message.insert(message.end(), first, first + sizeof(box));
    for (std::size_t a = 0; a < this->States.size(); ++a)
    {
      const std::size_t size = TupleSize(this->States[a]);
      ForRows(box,
        [&](Index j, Index k)
        {
          const char* row = source.Values[a] + source.Place({ { box.Lower[0], j, k } }) * size;
          message.insert(message.end(), row, row + box.Size(0) * size);
        });
    }
  }
  return message;
}

void LevelValues::AddParts(const Bytes& message)
{
  for (std::size_t at = 0; at < message.size();)
  {
    StateBlock source;
    std::memcpy(&source.Box, message.data() + at, sizeof(source.Box));
    source.Stored = source.Box;
    at += sizeof(source.Box);
    for (const StateArray& state : this->States)
    {
      source.Values.push_back(message.data() + at);
      at += source.Box.NumberOfCells() * TupleSize(state);
    }
    this->Sources.push_back(std::move(source));
  }
}

StateValues ExchangeState(const InputLevels& input, const std::vector<StateArray>& states,
  int level, const std::vector<BlockPlace>& owners, Ranks& ranks)
{
  StateValues values;
  for (int l = 0; l <= input.Finest(); ++l)
  {
    values.push_back(std::make_unique<LevelValues>(input.Levels[l], states));
    values.back()->Exchange(ChangeLevel(owners, l), GhostLayersOn(l, level), ranks);
  }
  return values;
}

} // namespace vfm
