/**
 * EqualFaces: finds the faces of elements that have the same points.
 */
#pragma once

#include "Base/Groups.h"
#include "Base/Sorted.h"
#include "Elements/ElementFaces.h"

#include <span>
#include <tuple>

namespace vfm
{

/// A face with a number, such as that of its element.
struct NumberedFace
{
  FaceIds Points; ///< ascending
  Index Number;
  bool operator<(const NumberedFace& other) const
  {
    return std::tie(this->Points, this->Number) < std::tie(other.Points, other.Number);
  }
};

/// Calls visit(same) for the faces with the same points, ascending by number, in the order of the
/// points. Faces are ordered in groups of those with about the same lowest point.
/// @param pointsOf  pointsOf(number) returns the points, ascending, of a face from 0 to count - 1
/// @param visit  takes std::span<const NumberedFace>
template <class PointsOf, class Visit>
void ForEqualFaces(std::size_t count, const PointsOf& pointsOf, const Visit& visit)
{
  if (count == 0)
  {
    return;
  }
  std::vector<Index> groupOf(count); // first the lowest point
  for (std::size_t f = 0; f < count; ++f)
  {
    const FaceIds points = pointsOf(static_cast<Index>(f));
    groupOf[f] = points[0] < 0 ? points[1] : points[0];
  }
  const auto [first, last] = std::minmax_element(groupOf.begin(), groupOf.end());
  const Index lowest = *first, range = *last - lowest + 1;
  const Index width = (range - 1) / static_cast<Index>(count) + 1; // points of a group
  for (Index& group : groupOf)
  {
    group = (group - lowest) / width;
  }
  const Groups<Index> groups = MakeGroups<Index>((range - 1) / width + 1,
    [&groupOf](const auto& add)
    {
      for (std::size_t f = 0; f < groupOf.size(); ++f)
      {
        add(groupOf[f], static_cast<Index>(f));
      }
    });
  groupOf = std::vector<Index>();
  std::vector<NumberedFace> faces;
  for (std::size_t group = 0; group + 1 < groups.Begin.size(); ++group)
  {
    faces.clear();
    for (Index at = groups.Begin[group]; at < groups.Begin[group + 1]; ++at)
    {
      faces.push_back({ pointsOf(groups.Items[at]), groups.Items[at] });
    }
    std::sort(faces.begin(), faces.end());
    ForRuns(
      faces.data(), faces.data() + faces.size(),
      [](const NumberedFace& a, const NumberedFace& b) { return a.Points == b.Points; },
      [&visit](const NumberedFace* begin, const NumberedFace* end)
      { visit(std::span<const NumberedFace>(begin, end)); });
  }
}

} // namespace vfm
