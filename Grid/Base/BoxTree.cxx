#include "Base/BoxTree.h"

#include <algorithm>
#include <numeric>

namespace vfm
{
namespace
{

constexpr int BoxesOfLeaf = 16;

} // namespace

BoxTree::BoxTree(std::vector<Bounds> boxes) : Boxes(std::move(boxes)), Items(this->Boxes.size())
{
  std::iota(this->Items.begin(), this->Items.end(), 0);
  if (!this->Boxes.empty())
  {
    this->Nodes.reserve(4 * this->Boxes.size() / BoxesOfLeaf + 1);
    this->Build(0, static_cast<int>(this->Boxes.size()));
  }
}

/// Halves the items by the middles of their boxes, along the longest side of the box around all.
void BoxTree::Build(int first, int last)
{
  const std::size_t number = this->Nodes.size();
  this->Nodes.emplace_back();
  Bounds all;
  for (int i = first; i < last; ++i)
  {
    all.Add(this->BoxOf(i));
  }
  this->Nodes[number].Box = all;
  if (last - first <= BoxesOfLeaf)
  {
    this->Nodes[number].First = first;
    this->Nodes[number].Last = last;
    this->Leaves.push_back(static_cast<int>(number));
  }
  else
  {
    int axis = 0;
    for (int a = 1; a < 3; ++a)
    {
      axis = all.Upper[a] - all.Lower[a] > all.Upper[axis] - all.Lower[axis] ? a : axis;
    }
    const auto middle = [&](int box)
    { return this->Boxes[box].Lower[axis] + this->Boxes[box].Upper[axis]; };
    const int half = (first + last) / 2;
    std::nth_element(this->Items.begin() + first, this->Items.begin() + half,
      this->Items.begin() + last, [&](int a, int b) { return middle(a) < middle(b); });
    this->Build(first, half);
    this->Build(half, last);
  }
  this->Nodes[number].Next = static_cast<int>(this->Nodes.size());
}

} // namespace vfm
