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

#include <algorithm>
#include <array>
#include <cstdint>
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

  /// Calls visit(point) for the points of groups `first` to before `last`, in their order.
  /// @param where  flags of the points; only flagged ones are visited; null: all. Visits may set
  ///   the flags of these points, and end them. Other threads may change other flags.
  template <class Visitor>
  void ForPoints(Index first, Index last, const unsigned char* where, const Visitor& visit) const
  {
    for (Index g = first; g < last;)
    {
      const Range& range = this->RangeOf[g / GroupsOfRange];
      const Index end = std::min(last, (g / GroupsOfRange + 1) * GroupsOfRange);
      g = !where || IsAny(where + range[0], where + range[1]) ? g : end;
      for (; g < end; ++g)
      {
        const Group& group = this->TheGroups[g];
        for (int point = group.First; point < group.Last; ++point)
        {
          if (!where || __atomic_load_n(where + point, __ATOMIC_RELAXED))
          {
            visit(point);
          }
        }
      }
    }
  }

private:
  static constexpr Index GroupsOfRange = 32;
  using Range = std::array<int, 2>; // from a point to before another

  /// Returns whether any flag is set; looks at eight at once.
  static bool IsAny(const unsigned char* first, const unsigned char* last)
  {
    typedef std::uint64_t __attribute__((may_alias)) Eight;
    for (; first < last && reinterpret_cast<std::uintptr_t>(first) % sizeof(Eight) != 0; ++first)
    {
      if (__atomic_load_n(first, __ATOMIC_RELAXED))
      {
        return true;
      }
    }
    for (; last - first >= static_cast<Index>(sizeof(Eight)); first += sizeof(Eight))
    {
      if (__atomic_load_n(reinterpret_cast<const Eight*>(first), __ATOMIC_RELAXED) != 0)
      {
        return true;
      }
    }
    return std::any_of(first, last,
      [](const unsigned char& flag) { return __atomic_load_n(&flag, __ATOMIC_RELAXED) != 0; });
  }
  void AddColours(const std::vector<Node>& nodes, int colours);
  void AddPlanes(const std::vector<Node>& nodes);
  void FindRanges();

  std::vector<Group> TheGroups;
  std::vector<Step> TheSteps;
  std::vector<Range> RangeOf; // points of each GroupsOfRange groups
};

} // namespace vfm
