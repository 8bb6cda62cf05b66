/**
 * MoveOrder: in which order the nodes of a rank move in a sweep.
 *
 * Points move by colour, the parity of their node: z first, then y, then x. Only neighbours feel which of two nodes moves first, so any order
 * in which all neighbours of different colours keep theirs makes the same mesh, bit for bit. By planes: an odd plane comes right after
 * the even ones around it, so do the rows in a plane and the nodes in a row, and a sweep goes through memory once and not once a colour.
 */
#pragma once

#include "Base/IndexBox.h"

#include <functional>

namespace vfm
{

class PointExchange;

class MoveOrder
{
public:
  /// The points of one node, moved one after another.
  struct Group
  {
    int First, Last;
  };
  /// A node that moves on this rank.
  struct Node
  {
    Index3 At;
    int Colour;
    Group Points;
  };
  /// Tasks that may run at the same time, each from Groups()[Tasks[t]] to before Groups()[Tasks[t + 1]].
  struct Step
  {
    std::vector<Index> Tasks;
    int Colour; ///< whose points other ranks get afterwards, or -1
  };

  MoveOrder() = default;
  /// Nodes of one colour share no element.
  static MoveOrder ByColour(const std::vector<Node>& nodes, int colours);
  /// Colours are parities of At, and nodes that share an element are neighbours: at most one apart along each axis. Points that other ranks
  /// have too come first, colour by colour, with all that move before them.
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
