#include "Base/BoxTree.h"

#include <algorithm>
#include <numeric>

namespace vfm
{
namespace
{

constexpr int BoxesOfLeaf = 16;

} // namespace

BoxTree::BoxTree(const std::vector<Bounds>& boxes) : Items(boxes.size())
{
  std::iota(this->Items.begin(), this->Items.end(), 0);
  if (!boxes.empty())
  {
    this->Nodes.reserve(4 * boxes.size() / BoxesOfLeaf + 1);
    this->Build(0, static_cast<int>(boxes.size()), boxes);
  }
  this->Boxes.reserve(boxes.size());
  for (int item : this->Items)
  {
    this->Boxes.push_back(boxes[item]);
  }
}

/// Halves the items by the middles of their boxes, along the longest side of the box around all.
void BoxTree::Build(int first, int last, const std::vector<Bounds>& boxes)
{
  const std::size_t number = this->Nodes.size();
  this->Nodes.emplace_back();
  Bounds all;
  for (int i = first; i < last; ++i)
  {
    all.Add(boxes[this->Items[i]]);
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
    const auto middle = [&](int item) { return boxes[item].Lower[axis] + boxes[item].Upper[axis]; };
    const int half = (first + last) / 2;
    std::nth_element(this->Items.begin() + first, this->Items.begin() + half,
      this->Items.begin() + last, [&](int a, int b) { return middle(a) < middle(b); });
    this->Build(first, half, boxes);
    this->Build(half, last, boxes);
  }
  this->Nodes[number].Next = static_cast<int>(this->Nodes.size());
}

} // namespace vfm
