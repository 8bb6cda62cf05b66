#include "Smoothing/MoveOrder.h"

#include "Base/CartesianGrid.h"
#include "Base/Groups.h"
#include "Elements/PointExchange.h"

namespace vfm
{
namespace
{

using Node = MoveOrder::Node;

constexpr Index GroupsOfTask = 32;  // nodes of one colour
constexpr Index LeastOfChunk = 256; // points; the smallest chunk that is worth a thread
constexpr Index MaximumChunks = 32;
constexpr Index EnoughChunks = 8;

/// Returns the position of a plane in the order: odd planes follow the even planes next to them.
Index SlotOf(Index plane)
{
  return (plane & 1) != 0 ? plane + 2 : plane;
}

/// Returns the box of all nodes, their neighbours and slots.
IndexBox BoxAround(const std::vector<Node>& nodes)
{
  IndexBox box = BoxOfCell(nodes.empty() ? Index3{} : nodes[0].At);
  for (const Node& node : nodes)
  {
    for (int a = 0; a < 3; ++a)
    {
      box.Lower[a] = std::min(box.Lower[a], node.At[a] - 1);
      box.Upper[a] = std::max(box.Upper[a], node.At[a] + 3);
    }
  }
  return box;
}

Index CountPoints(const Node& node)
{
  return node.Points.Last - node.Points.First;
}

/// Division of nodes along an axis into chunks, which begin and end with even planes, and the odd
/// planes between them. The chunks may move at the same time, then the planes between. This repeats
/// for each combination of parities along the axes above this one.
class Chunks
{
public:
  Chunks(const std::vector<Node>& nodes, int axis) : Axis(axis)
  {
    const auto [least, most] = std::minmax_element(nodes.begin(), nodes.end(),
      [axis](const Node& a, const Node& b) { return a.At[axis] < b.At[axis]; });
    this->First = least->At[axis] & ~Index(1);
    std::vector<Index> points((most->At[axis] - this->First) / 2 + 1, 0);
    for (const Node& node : nodes)
    {
      points[this->PairOf(node)] += CountPoints(node);
      this->Total += CountPoints(node);
    }
    this->Cut(points);
  }

  /// Return the points of the largest chunk, which limits the use of threads, and of all.
  Index Largest() const { return this->TheLargest; }
  Index Points() const { return this->Total; }

  int CountSteps() const { return 2 << (2 - this->Axis); }
  Index CountTasks() const { return this->Count; } // largest number of tasks of a step
  int StepOf(const Node& node) const
  {
    int step = this->IsBetween(node) ? 1 : 0;
    for (int a = this->Axis + 1; a < 3; ++a)
    {
      step |= static_cast<int>(node.At[a] & 1) << (a - this->Axis);
    }
    return step;
  }
  Index TaskOf(const Node& node) const { return this->ChunkOfPair[this->PairOf(node)]; }

private:
  /// Returns the number of the pair of an even plane and the odd one after it.
  Index PairOf(const Node& node) const { return (node.At[this->Axis] - this->First) / 2; }
  bool IsBetween(const Node& node) const
  {
    const std::size_t pair = this->PairOf(node);
    return (node.At[this->Axis] & 1) != 0 && pair + 1 < this->ChunkOfPair.size() &&
      this->ChunkOfPair[pair] != this->ChunkOfPair[pair + 1];
  }

  /// Cuts the pairs of planes into chunks with similar numbers of points.
  void Cut(const std::vector<Index>& points)
  {
    const Index pairs = static_cast<Index>(points.size());
    const Index requested = std::min({ MaximumChunks, 1 + this->Total / LeastOfChunk, pairs });
    Index sum = 0, inChunk = 0;
    for (Index own : points)
    {
      if (inChunk > 0 && (sum + own / 2) * requested >= (this->Count + 1) * this->Total)
      {
        ++this->Count;
        inChunk = 0;
      }
      this->ChunkOfPair.push_back(this->Count);
      sum += own;
      inChunk += own;
      this->TheLargest = std::max(this->TheLargest, inChunk);
    }
    ++this->Count;
  }

  int Axis;
  Index First, Total = 0, TheLargest = 0, Count = 0;
  std::vector<Index> ChunkOfPair;
};

/// Returns chunks along the last axis if they are small enough for several threads, because
/// these take the fewest steps. Otherwise an earlier axis is chosen if it more than halves the
/// largest chunk.
Chunks ChooseChunks(const std::vector<Node>& nodes)
{
  Chunks best(nodes, 2);
  for (int axis = 1; axis >= 0 && best.Largest() * EnoughChunks > 2 * best.Points(); --axis)
  {
    const Chunks other(nodes, axis);
    best = 2 * other.Largest() < best.Largest() ? other : best;
  }
  return best;
}

/// Set of the nodes that must move before any of the given nodes has moved: the given nodes and,
/// recursively, neighbours of lower colours.
class Forerunners
{
public:
  explicit Forerunners(const std::vector<Node>& nodes) :
    Nodes(nodes), Box(BoxAround(nodes)), IsOne(nodes.size(), 0)
  {
    this->Places.reserve(nodes.size());
    for (std::size_t n = 0; n < nodes.size(); ++n)
    {
      this->Places.push_back({ { IndexInBox(this->Box, nodes[n].At), static_cast<Index>(n) } });
    }
    if (!std::is_sorted(this->Places.begin(), this->Places.end())) // mostly they are
    {
      std::sort(this->Places.begin(), this->Places.end());
    }
  }

  void Add(std::size_t node)
  {
    if (!this->IsOne[node])
    {
      this->IsOne[node] = 1;
      this->OfColour[this->Nodes[node].Colour % 8].push_back(node);
    }
  }

  /// Returns whether each node is in the set.
  std::vector<unsigned char> Find()
  {
    for (std::size_t colour = 8; colour-- > 0;)
    {
      for (std::size_t node : this->OfColour[colour]) // appends only to lists of lower colours
      {
        this->AddAround(node);
      }
    }
    return std::move(this->IsOne);
  }

private:
  void AddAround(std::size_t node)
  {
    const Index3& at = this->Nodes[node].At;
    for (Index row = 0; row < 9; ++row)
    {
      const Index place =
        IndexInBox(this->Box, { { at[0] - 1, at[1] + row % 3 - 1, at[2] + row / 3 - 1 } });
      auto other = std::lower_bound(
        this->Places.begin(), this->Places.end(), std::array<Index, 2>{ { place, 0 } });
      for (; other != this->Places.end() && (*other)[0] <= place + 2; ++other)
      {
        if (this->Nodes[(*other)[1]].Colour < this->Nodes[node].Colour)
        {
          this->Add((*other)[1]);
        }
      }
    }
  }

  const std::vector<Node>& Nodes;
  const IndexBox Box;
  std::vector<std::array<Index, 2>> Places; // position in the box, node
  std::vector<unsigned char> IsOne;
  std::array<std::vector<std::size_t>, 8> OfColour;
};

/// Returns whether each node has a point that other ranks hold, or must move before such a node.
std::vector<unsigned char> FindRim(const std::vector<Node>& nodes, const PointExchange& exchange)
{
  int points = 0;
  for (const Node& node : nodes)
  {
    points = std::max(points, node.Points.Last);
  }
  std::vector<unsigned char> isShared(points, 0);
  exchange.ForSent([&](int mover) { isShared[mover] = 1; });
  Forerunners rim(nodes);
  for (std::size_t n = 0; n < nodes.size(); ++n)
  {
    const auto begin = isShared.begin() + nodes[n].Points.First;
    if (std::find(begin, isShared.begin() + nodes[n].Points.Last, 1) !=
      isShared.begin() + nodes[n].Points.Last)
    {
      rim.Add(n);
    }
  }
  return rim.Find();
}

} // namespace

MoveOrder MoveOrder::ByColour(const std::vector<Node>& nodes, int colours)
{
  MoveOrder order;
  order.AddColours(nodes, colours);
  order.FindRanges();
  return order;
}

void MoveOrder::AddColours(const std::vector<Node>& nodes, int colours)
{
  const auto ofColour = MakeGroups<Index>(colours,
    [&](const auto& visit)
    {
      for (std::size_t n = 0; n < nodes.size(); ++n)
      {
        visit(nodes[n].Colour, static_cast<Index>(n));
      }
    });
  for (int colour = 0; colour < colours; ++colour)
  {
    this->TheSteps.push_back({ {}, colour });
    for (Index at = ofColour.Begin[colour]; at < ofColour.Begin[colour + 1]; ++at)
    {
      if ((at - ofColour.Begin[colour]) % GroupsOfTask == 0)
      {
        this->TheSteps.back().Tasks.push_back(static_cast<Index>(this->TheGroups.size()));
      }
      this->TheGroups.push_back(nodes[ofColour.Items[at]].Points);
    }
    this->TheSteps.back().Tasks.push_back(static_cast<Index>(this->TheGroups.size()));
  }
}

MoveOrder MoveOrder::ByPlanes(const std::vector<Node>& nodes, const PointExchange& exchange)
{
  MoveOrder order;
  if (!exchange.HasPeers())
  {
    order.AddPlanes(nodes);
    order.FindRanges();
    return order;
  }
  const std::vector<unsigned char> isRim = FindRim(nodes, exchange);
  std::vector<Node> rim, inside;
  for (std::size_t n = 0; n < nodes.size(); ++n)
  {
    (isRim[n] ? rim : inside).push_back(nodes[n]);
  }
  order.AddColours(rim, exchange.CountColours());
  order.AddPlanes(inside);
  order.FindRanges();
  return order;
}

void MoveOrder::AddPlanes(const std::vector<Node>& nodes)
{
  if (nodes.empty())
  {
    return;
  }
  const Chunks chunks = ChooseChunks(nodes);
  const Index tasks = chunks.CountTasks();
  const IndexBox box = BoxAround(nodes);
  const auto placeOf = [&box](const Index3& p) {
    return IndexInBox(box, { { SlotOf(p[0]), SlotOf(p[1]), SlotOf(p[2]) } });
  };
  auto places = MakeGroups<std::array<Index, 2>>(chunks.CountSteps() * tasks,
    [&](const auto& visit)
    {
      for (std::size_t n = 0; n < nodes.size(); ++n)
      {
        visit(chunks.StepOf(nodes[n]) * tasks + chunks.TaskOf(nodes[n]),
          { { placeOf(nodes[n].At), static_cast<Index>(n) } });
      }
    });
  for (int step = 0; step < chunks.CountSteps(); ++step)
  {
    this->TheSteps.push_back({ {}, -1 });
    std::vector<Index>& begins = this->TheSteps.back().Tasks;
    for (Index task = step * tasks; task < (step + 1) * tasks; ++task)
    {
      const auto begin = places.Items.begin() + places.Begin[task],
                 end = places.Items.begin() + places.Begin[task + 1];
      std::sort(begin, end);
      if (begin != end)
      {
        begins.push_back(static_cast<Index>(this->TheGroups.size()));
      }
      std::for_each(begin, end,
        [&](const std::array<Index, 2>& place)
        { this->TheGroups.push_back(nodes[place[1]].Points); });
    }
    begins.push_back(static_cast<Index>(this->TheGroups.size()));
  }
}

void MoveOrder::FindRanges()
{
  for (std::size_t g = 0; g < this->TheGroups.size(); ++g)
  {
    const auto& [first, last] = this->TheGroups[g];
    if (g % GroupsOfRange == 0)
    {
      this->RangeOf.push_back({ { first, last } });
    }
    Range& range = this->RangeOf.back();
    range = { { std::min(range[0], first), std::max(range[1], last) } };
  }
}

} // namespace vfm
