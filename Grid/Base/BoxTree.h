/**
 * BoxTree: a search tree of boxes with sides along the axes, to find the pairs of boxes that touch.
 */
#pragma once

#include "Base/CartesianGrid.h"
#include "Base/Runtime.h"

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

/// Binary tree of boxes.
class BoxTree
{
public:
  BoxTree(std::vector<Bounds> boxes, Runtime& runtime);
  /// Calls visit(i, j) once for each pair of boxes that touch, possibly several pairs at the same
  /// time.
  template <class Visitor>
  void ForPairs(Runtime& runtime, const Visitor& visit) const;

private:
  /// Node of the tree; a leaf has boxes.
  struct Node
  {
    Bounds Box;
    int Next = 0;            // the first node behind all nodes below this one
    int First = 0, Last = 0; // range of Items; empty unless this is a leaf
  };
  /// Node with all nodes below it: its number and the range of Items.
  struct Part
  {
    int Number, First, Last;
  };
  std::vector<Part> Halve(const Part& part);
  void Build(const Part& part);
  const Bounds& BoxOf(int item) const { return this->Boxes[this->Items[item]]; }
  template <class Visitor>
  void ForPairs(const Node& a, const Node& b, const Visitor& visit) const;

  std::vector<Bounds> Boxes;
  std::vector<int> Items;  // numbers of the boxes, in the order of the leaves
  std::vector<Node> Nodes; // in preorder
  std::vector<int> Leaves; // numbers of nodes, ascending
};

template <class Visitor>
void BoxTree::ForPairs(Runtime& runtime, const Visitor& visit) const
{
  const int nodes = static_cast<int>(this->Nodes.size());
  ForEach(runtime, this->Leaves.size(),
    [&](Index number)
    {
      const Node& leaf = this->Nodes[this->Leaves[number]];
      for (int n = this->Leaves[number]; n < nodes;) // earlier leaves have visited this one
      {
        const Node& node = this->Nodes[n];
        const bool touches = node.Box.Touches(leaf.Box);
        if (touches && node.First < node.Last)
        {
          this->ForPairs(leaf, node, visit);
        }
        n = touches ? n + 1 : node.Next;
      }
    });
}

/// Visits the pairs of the boxes of two leaves, or of one.
template <class Visitor>
void BoxTree::ForPairs(const Node& a, const Node& b, const Visitor& visit) const
{
  for (int i = a.First; i < a.Last; ++i)
  {
    const Bounds& box = this->BoxOf(i);
    for (int j = &a == &b ? i + 1 : b.First; j < b.Last && box.Touches(b.Box); ++j)
    {
      if (box.Touches(this->BoxOf(j)))
      {
        visit(this->Items[i], this->Items[j]);
      }
    }
  }
}

} // namespace vfm
