/**
 * MoveOrder: the order in which a sweep moves the nodes of a rank.
 *
 * Points move by colour, the parity of their node, of which z is the most significant, then y, then
 * x. Only neighbours are affected by which of two nodes moves first. Any order that keeps
 * neighbours of different colours in order therefore makes a bitwise identical mesh. In the order
 * by planes, an odd plane follows the even planes on both sides of it; rows in a plane and nodes in
 * a row follow the same rule. A sweep then passes through memory once, not once per colour.
 */
#pragma once

#include "Base/IndexBox.h"

#include <functional>

namespace vfm
{

class PointExchange;

/// Steps of a sweep, each with tasks that may run at the same time. Each owned node is in exactly
/// one step.
class MoveOrder
{
public:
  /// Points of one node, moved one after another.
  struct Group
  {
    int First, Last;
  };
  /// Node that moves on this rank.
  struct Node
  {
    Index3 At;
    int Colour;
    Group Points;
  };
  /// Tasks that may run at the same time. Task t moves Groups()[Tasks[t]] to before
  /// Groups()[Tasks[t + 1]].
  struct Step
  {
    std::vector<Index> Tasks;
    /// Colour whose points are sent to other ranks after the step, or -1.
    int Colour;
  };

  MoveOrder() = default;
  /// Returns an order by colour, one step per colour.
  /// @pre Nodes of one colour share no element.
  static MoveOrder ByColour(const std::vector<Node>& nodes, int colours);
  /// Returns an order by planes. Nodes with points that other ranks hold move first, colour by
  /// colour, together with all nodes that must move before them.
  /// @pre Colours are parities of At. Nodes that share an element are at most one apart along
  /// each axis.
  static MoveOrder ByPlanes(const std::vector<Node>& nodes, const PointExchange& exchange);

  const std::vector<Group>& Groups() const { return this->TheGroups; }
  const std::vector<Step>& Steps() const { return this->TheSteps; }

private:
  void AddColours(const std::vector<Node>& nodes, int colours);
  void AddPlanes(const std::vector<Node>& nodes);

  std::vector<Group> TheGroups;
  std::vector<Step> TheSteps;
};

} // namespace vfm
