#include "Base/BoxTree.h"

#include "Base/Groups.h"

#include <algorithm>
#include <numeric>

namespace vfm
{
namespace
{

constexpr int BoxesOfLeaf = 16;
// Number of uppermost levels. Threads share the nodes of each, then the parts of the tree below.
constexpr int SharedLevels = 6;

/// Returns the number of nodes of a tree of a number of items.
int CountNodes(int items)
{
  return items <= BoxesOfLeaf ? 1 : 1 + CountNodes(items / 2) + CountNodes(items - items / 2);
}

} // namespace

BoxTree::BoxTree(std::vector<Bounds> boxes, Runtime& runtime) :
  Boxes(std::move(boxes)), Items(this->Boxes.size())
{
  std::iota(this->Items.begin(), this->Items.end(), 0);
  if (this->Boxes.empty())
  {
    return;
  }
  const int count = static_cast<int>(this->Boxes.size());
  this->Nodes.resize(CountNodes(count));
  std::vector<Part> parts{ { 0, 0, count } };
  for (int level = 0; level < SharedLevels; ++level)
  {
    std::vector<std::vector<Part>> halves(parts.size());
    ForEach(runtime, parts.size(), [&](Index p) { halves[p] = this->Halve(parts[p]); });
    parts = Joined(halves);
  }
  ForEach(runtime, parts.size(), [&](Index p) { this->Build(parts[p]); });
  for (std::size_t n = 0; n < this->Nodes.size(); ++n)
  {
    if (this->Nodes[n].First < this->Nodes[n].Last)
    {
      this->Leaves.push_back(static_cast<int>(n));
    }
  }
}

/// Sets the node of a part. Halves its items by the middles of their boxes, along the longest side
/// of the box around all; returns the halves, or nothing for a leaf.
std::vector<BoxTree::Part> BoxTree::Halve(const Part& part)
{
  Node& node = this->Nodes[part.Number];
  for (int i = part.First; i < part.Last; ++i)
  {
    node.Box.Add(this->BoxOf(i));
  }
  const int items = part.Last - part.First;
  node.Next = part.Number + CountNodes(items);
  if (items <= BoxesOfLeaf)
  {
    node.First = part.First;
    node.Last = part.Last;
    return {};
  }
  const Bounds& all = node.Box;
  int axis = 0;
  for (int a = 1; a < 3; ++a)
  {
    axis = all.Upper[a] - all.Lower[a] > all.Upper[axis] - all.Lower[axis] ? a : axis;
  }
  const auto middle = [&](int box)
  { return this->Boxes[box].Lower[axis] + this->Boxes[box].Upper[axis]; };
  const int half = part.First + items / 2;
  std::nth_element(this->Items.begin() + part.First, this->Items.begin() + half,
    this->Items.begin() + part.Last, [&](int a, int b) { return middle(a) < middle(b); });
  const int second = part.Number + 1 + CountNodes(items / 2);
  return { { part.Number + 1, part.First, half }, { second, half, part.Last } };
}

void BoxTree::Build(const Part& part)
{
  for (const Part& half : this->Halve(part))
  {
    this->Build(half);
  }
}

} // namespace vfm
