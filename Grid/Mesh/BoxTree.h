/**
 * BoxTree: a search tree of boxes with sides along the axes, to find the boxes that overlap a box.
 */
#pragma once

#include "Base/CartesianGrid.h"

#include <vector>

namespace vfm
{

/// Box with sides along the axes. It can be flat. Made empty.
struct Bounds
{
  Vector3 Lower{ { 1e300, 1e300, 1e300 } }, Upper{ { -1e300, -1e300, -1e300 } };

  void Add(const Vector3& x)
  {
    for (int a = 0; a < 3; ++a)
    {
      this->Lower[a] = x[a] < this->Lower[a] ? x[a] : this->Lower[a];
      this->Upper[a] = x[a] > this->Upper[a] ? x[a] : this->Upper[a];
    }
  }
  void Add(const Bounds& box)
  {
    this->Add(box.Lower);
    this->Add(box.Upper);
  }
  /// Returns whether two boxes have a common point, possibly on their sides.
  bool Touches(const Bounds& other) const
  {
    return this->Lower[0] <= other.Upper[0] && other.Lower[0] <= this->Upper[0] &&
      this->Lower[1] <= other.Upper[1] && other.Lower[1] <= this->Upper[1] &&
      this->Lower[2] <= other.Upper[2] && other.Lower[2] <= this->Upper[2];
  }
};

/// Tree of boxes. Reading is thread safe.
class BoxTree
{
public:
  explicit BoxTree(const std::vector<Bounds>& boxes);
  /// Calls visit(i) for all boxes that touch a box.
  template <class Visitor>
  void ForTouching(const Bounds& box, const Visitor& visit) const;

private:
  /// Node of a binary tree in preorder.
  struct Node
  {
    Bounds Box;
    int Next = 0;            // the node after all nodes below this one
    int First = 0, Last = 0; // range of Items; empty unless this is a leaf
  };
  void Build(int first, int last, const std::vector<Bounds>& boxes);

  std::vector<int> Items; // numbers of the boxes
  std::vector<Bounds> Boxes; // in the order of Items
  std::vector<Node> Nodes;
};

template <class Visitor>
void BoxTree::ForTouching(const Bounds& box, const Visitor& visit) const
{
  for (int n = 0; n < static_cast<int>(this->Nodes.size());)
  {
    const Node& node = this->Nodes[n];
    const bool touches = node.Box.Touches(box);
    for (int i = node.First; touches && i < node.Last; ++i)
    {
      if (this->Boxes[i].Touches(box))
      {
        visit(this->Items[i]);
      }
    }
    n = touches ? n + 1 : node.Next;
  }
}

} // namespace vfm
