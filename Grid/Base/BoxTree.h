/**
 * BoxTree: a search tree of boxes with sides along the axes, to find the pairs of boxes that touch,
 * or the boxes near a point.
 */
#pragma once

#include "Base/CartesianGrid.h"
#include "Base/Runtime.h"

#include <utility>
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
  /// Returns the square of the distance of a point; 0 inside.
  double SquareTo(const Vector3& x) const
  {
    double sum = 0.0;
    for (int a = 0; a < 3; ++a)
    {
      const double below = this->Lower[a] - x[a], above = x[a] - this->Upper[a];
      const double out = below > 0.0 ? below : above > 0.0 ? above : 0.0;
      sum += out * out;
    }
    return sum;
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
  /// Calls visit(i) for the boxes with distance(box) <= limit, mostly near boxes first; visit may
  /// lower the limit.
  /// @param distance  returns a number that is not larger for a box around other boxes
  template <class Distance, class Visitor>
  void ForNear(const Distance& distance, const double& limit, const Visitor& visit) const;

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

template <class Distance, class Visitor>
void BoxTree::ForNear(const Distance& distance, const double& limit, const Visitor& visit) const
{
  std::array<std::pair<int, double>, 64> toDo; // nodes and distances; a tree has fewer levels
  int count = 0;
  if (!this->Nodes.empty())
  {
    toDo[count++] = { 0, distance(this->Nodes[0].Box) };
  }
  while (count > 0)
  {
    const auto [number, away] = toDo[--count];
    const Node& node = this->Nodes[number];
    if (away > limit)
    {
      continue;
    }
    for (int i = node.First; i < node.Last; ++i)
    {
      if (distance(this->BoxOf(i)) <= limit)
      {
        visit(this->Items[i]);
      }
    }
    if (node.First == node.Last)
    {
      const int first = number + 1, second = this->Nodes[first].Next;
      std::pair<int, double> near{ first, distance(this->Nodes[first].Box) };
      std::pair<int, double> far{ second, distance(this->Nodes[second].Box) };
      if (far.second < near.second)
      {
        std::swap(near, far);
      }
      toDo[count++] = far;
      toDo[count++] = near;
    }
  }
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
