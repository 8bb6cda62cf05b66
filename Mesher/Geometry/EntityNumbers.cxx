#include "Geometry/EntityNumbers.h"

namespace vfm
{
namespace
{

/// Members of a set, followed by zeros; or the number of the members before, and further members.
using Chunk = std::array<int, 8>;

/// Returns the next members of each set. Zeros at the end keep the lexicographic order.
/// @param first  position of the members in the sets
/// @param before  number of the members before `first` in each set; empty if first is 0
std::vector<Chunk> TakeChunks(
  const std::vector<std::vector<int>>& sets, std::size_t first, const std::vector<int>& before)
{
  std::vector<Chunk> chunks;
  chunks.reserve(sets.size());
  for (std::size_t s = 0; s < sets.size(); ++s)
  {
    Chunk chunk{};
    std::size_t at = 0;
    if (first > 0)
    {
      chunk[at++] = before[s];
    }
    for (std::size_t i = first; i < sets[s].size() && at < chunk.size(); ++i)
    {
      chunk[at++] = sets[s][i];
    }
    chunks.push_back(chunk);
  }
  return chunks;
}

} // namespace

EntityNumbers<std::vector<int>> NumberSets(
  EntityKeys<std::vector<int>> sets, Index largest, const char* things, Ranks& ranks)
{
  std::size_t own = 0;
  for (const std::vector<int>& set : sets.Keys)
  {
    own = std::max(own, set.size());
  }
  const auto longest = static_cast<std::size_t>(ranks.Max(static_cast<double>(own)));
  const auto value = [largest](const Chunk& chunk)
  { return chunk[0] * (largest + 1) + std::min<Index>(chunk[1], largest); };
  std::vector<int> before;
  std::vector<Chunk> chunks = TakeChunks(sets.Keys, 0, before);
  for (std::size_t first = std::tuple_size<Chunk>::value; first < longest;
       first += std::tuple_size<Chunk>::value - 1)
  {
    std::vector<Chunk> distinct = chunks;
    SortUnique(distinct);
    const KeyNumbers numbers = NumberKeys(distinct, value, ranks);
    CheckNumberLimit(numbers.Total, things);
    before.clear();
    for (const Chunk& chunk : chunks)
    {
      before.push_back(static_cast<int>(numbers.Numbers[FindSorted(distinct, chunk)]) + 1);
    }
    chunks = TakeChunks(sets.Keys, first, before);
  }
  return { std::move(sets.Keys), NumberOwnedKeys(chunks, sets.IsOwned, value, ranks), things };
}

} // namespace vfm
