#include "Input/MakePartition.h"

#include "Ranks/Agreement.h"
#include "Ranks/SumOverRange.h"

#include <cmath>

namespace vfm
{
namespace
{

/// A box that the ranks [First, First + Count) divide.
struct Part
{
  IndexBox Box;
  int First, Count;
};

/// Numbers of up to 63 bits, in 7 bits per byte; small ones take one byte.
void AddNumber(Index number, Bytes& bytes)
{
  for (; number > 127; number >>= 7)
  {
    bytes.push_back(static_cast<char>((number & 127) | 128));
  }
  bytes.push_back(static_cast<char>(number));
}

Index TakeNumber(Bytes::const_iterator& at)
{
  Index number = 0;
  int shift = 0;
  for (; (*at & 128) != 0; shift += 7)
  {
    number |= Index(*at++ & 127) << shift;
  }
  return number | Index(*at++) << shift;
}

/// The weights of cells that this rank holds.
class Weights
{
public:
  Weights(std::vector<IndexBox> blocks, std::vector<Index3> interfaceCells) :
    Blocks(std::move(blocks)), Cells(std::move(interfaceCells))
  {
  }

  Index Total() const
  {
    Index total = static_cast<Index>(this->Cells.size()) * InterfaceCellWeight;
    for (const IndexBox& block : this->Blocks)
    {
      total += block.NumberOfCells() * CellWeight;
    }
    return total;
  }

  /// Returns the weights of the planes of a box across an axis.
  std::vector<Index> WeighPlanes(const IndexBox& box, int axis) const
  {
    std::vector<Index> planes(box.Size(axis), 0);
    const int b = (axis + 1) % 3, c = (axis + 2) % 3;
    for (const IndexBox& block : this->Blocks)
    {
      const IndexBox common = Intersect(block, box);
      for (Index x = common.Lower[axis]; x < common.Upper[axis]; ++x)
      {
        planes[x - box.Lower[axis]] += CellWeight * common.Size(b) * common.Size(c);
      }
    }
    for (const Index3& cell : this->Cells)
    {
      planes[cell[axis] - box.Lower[axis]] += InterfaceCellWeight;
    }
    return planes;
  }

  /// Removes the weights of the cells in a box, and returns them as a message.
  Bytes Take(const IndexBox& box);
  /// Adds the weights of a message for the same box.
  void Add(const IndexBox& box, const Bytes& message);

private:
  std::vector<IndexBox> Blocks;
  std::vector<Index3> Cells;
};

/// The message has the blocks, then the distances of the cells from each other in the box.
Bytes Weights::Take(const IndexBox& box)
{
  std::vector<IndexBox> blocks;
  for (const IndexBox& block : this->Blocks)
  {
    const IndexBox common = Intersect(block, box);
    if (common.NumberOfCells() > 0)
    {
      blocks.push_back(common);
    }
  }
  const auto kept = std::partition(this->Cells.begin(), this->Cells.end(),
    [&box](const Index3& cell) { return !box.Contains(cell); });
  std::vector<Index> places;
  for (auto cell = kept; cell != this->Cells.end(); ++cell)
  {
    places.push_back(IndexInBox(box, *cell));
  }
  this->Cells.erase(kept, this->Cells.end());
  std::sort(places.begin(), places.end());
  Bytes message;
  AddNumber(static_cast<Index>(blocks.size()), message);
  const Bytes packed = ToBytes(blocks);
  message.insert(message.end(), packed.begin(), packed.end());
  Index last = 0;
  for (Index place : places)
  {
    AddNumber(place - last, message);
    last = place;
  }
  return message;
}

void Weights::Add(const IndexBox& box, const Bytes& message)
{
  auto at = message.begin();
  const Index count = TakeNumber(at);
  const auto end = at + static_cast<std::ptrdiff_t>(count * sizeof(IndexBox));
  const std::vector<IndexBox> blocks = FromBytes<IndexBox>(Bytes(at, end));
  this->Blocks.insert(this->Blocks.end(), blocks.begin(), blocks.end());
  Index place = 0;
  for (at = end; at != message.end();)
  {
    place += TakeNumber(at);
    this->Cells.push_back(CellInBox(box, place));
  }
}

IndexBox FindBounds(const std::vector<IndexBox>& boxes)
{
  IndexBox bounds;
  for (std::size_t b = 0; b < boxes.size(); ++b)
  {
    for (int a = 0; a < 3; ++a)
    {
      bounds.Lower[a] = b ? std::min(bounds.Lower[a], boxes[b].Lower[a]) : boxes[b].Lower[a];
      bounds.Upper[a] = b ? std::max(bounds.Upper[a], boxes[b].Upper[a]) : boxes[b].Upper[a];
    }
  }
  return bounds;
}

/// Returns whether every rank holds one box and weights are balanced (GoodBalance).
bool IsPartition(const std::vector<IndexBox>& blocks, const Weights& weights, Ranks& ranks)
{
  Index cells = 0;
  for (const IndexBox& block : blocks)
  {
    cells += block.NumberOfCells();
  }
  const bool isBox = cells == FindBounds(blocks).NumberOfCells();
  std::vector<Index> sums{ isBox ? 0 : 1, weights.Total() };
  ranks.Sum(sums);
  const double greatest = ranks.Max(static_cast<double>(weights.Total()));
  return sums[0] == 0 && greatest * ranks.Count() <= GoodBalance * static_cast<double>(sums[1]);
}

int FindLongestAxis(const IndexBox& box)
{
  int longest = 0;
  for (int a = 1; a < 3; ++a)
  {
    longest = box.Size(a) > box.Size(longest) ? a : longest;
  }
  return longest;
}

/// Returns the number of planes whose weight is nearest to a share of the total; each side gets at
/// least one plane if there are two.
Index FindCut(const Index* planes, Index count, double share)
{
  double total = 0.0, sum = 0.0;
  for (Index x = 0; x < count; ++x)
  {
    total += static_cast<double>(planes[x]);
  }
  Index cut = std::min<Index>(count, 1);
  double best = -1.0;
  for (Index x = 1; x < count; ++x)
  {
    sum += static_cast<double>(planes[x - 1]);
    const double miss = std::abs(sum - share * total);
    if (best < 0.0 || miss < best)
    {
      best = miss;
      cut = x;
    }
  }
  return cut;
}

/// Returns the halves of a part of several ranks.
/// @pre Collective over the ranks of the part.
std::array<Part, 2> Halve(const Part& part, const Weights& weights, Ranks& ranks)
{
  const int axis = FindLongestAxis(part.Box);
  std::vector<Index> planes = weights.WeighPlanes(part.Box, axis);
  SumOverRange(part.First, part.Count, planes, ranks);
  Part lower = part, upper = part;
  lower.Count /= 2;
  upper.First += lower.Count;
  upper.Count -= lower.Count;
  const double share = static_cast<double>(lower.Count) / part.Count;
  lower.Box.Upper[axis] = upper.Box.Lower[axis] =
    part.Box.Lower[axis] + FindCut(planes.data(), part.Box.Size(axis), share);
  return { { lower, upper } };
}

/// Sends the weights of cells in the other half to a rank of it, and adds those received.
/// @pre Collective over the ranks of both halves.
void SwapWeights(const Part& own, const Part& other, Weights& weights, Ranks& ranks)
{
  const int place = ranks.Rank() - own.First;
  std::vector<int> partners{ other.First + std::min(place, other.Count - 1) };
  std::vector<Bytes> messages{ weights.Take(other.Box) };
  if (place == own.Count - 1 && own.Count < other.Count) // also that of the last rank
  {
    partners.push_back(other.First + own.Count);
    messages.push_back(Weights({}, {}).Take(other.Box));
  }
  for (const Bytes& message : ranks.Exchange(partners, messages))
  {
    weights.Add(own.Box, message);
  }
}

} // namespace

void FindInterfaceCells(const IndexBox& box, const RowReader& read, std::vector<Index3>& found)
{
  const Index n = box.Size(0), plane = n * box.Size(1);
  std::vector<int> last(plane),
    row(n); // last: previous rows of this plane, then the remaining rows of the previous plane
  ForRows(box,
    [&](Index j, Index k)
    {
      int* below = last.data() + (j - box.Lower[1]) * n;
      read({ { box.Lower[0], j, k } }, n, row.data());
      for (Index i = 0; i < n; ++i)
      {
        const int material = row[i];
        if (material < 0 || (i > 0 && row[i - 1] != material) ||
          (j > box.Lower[1] && below[i - n] != material) ||
          (k > box.Lower[2] && below[i] != material))
        {
          found.push_back({ { box.Lower[0] + i, j, k } });
        }
      }
      std::copy(row.begin(), row.end(), below);
    });
}

IndexBox MakePartition(const IndexBox& global, const std::vector<IndexBox>& blocks,
  const std::function<std::vector<Index3>()>& findInterfaceCells, Ranks& ranks, bool mayStay)
{
  if (ranks.Count() == 1)
  {
    return global;
  }
  std::vector<Index3> cells;
  WorkTogether(ranks, [&] { cells = findInterfaceCells(); });
  Weights weights(blocks, std::move(cells));
  if (mayStay && IsPartition(blocks, weights, ranks))
  {
    return FindBounds(blocks);
  }
  Part part{ global, 0, ranks.Count() };
  while (part.Count > 1)
  {
    const std::array<Part, 2> halves = Halve(part, weights, ranks);
    const bool isUpper = ranks.Rank() >= halves[1].First;
    part = halves[isUpper];
    SwapWeights(part, halves[!isUpper], weights, ranks);
  }
  return part.Box;
}

} // namespace vfm
