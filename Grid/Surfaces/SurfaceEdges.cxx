#include "Surfaces/SurfaceEdges.h"

#include "Base/Groups.h"
#include "Ranks/Errors.h"
#include "Surfaces/WeldPoints.h"

#include <algorithm>
#include <charconv>
#include <string>
#include <tuple>

namespace vfm
{
namespace
{

constexpr double Near = 1e-3; // of the diagonal: points that a hint of a message names

std::string FormatEdge(const std::vector<Vector3>& points, const TriangleSide& edge)
{
  return "from " + FormatPlace(points[edge.Low]) + " to " + FormatPlace(points[edge.High]);
}

/// Returns a hint to the smallest distance between points of open edges that no open edge joins, if
/// it is small.
std::string HintAtWelding(const std::vector<Vector3>& points, const std::vector<TriangleSide>& open)
{
  double nearest = Near * FindDiagonal(points);
  bool isFound = false;
  ForClosePairs(points, EndsOf(open), nearest,
    [&](Index a, Index b)
    {
      const double distance = Norm(points[a] - points[b]);
      const bool areJoined =
        std::binary_search(open.begin(), open.end(), TriangleSide{ a, b, 0, true },
          [](const TriangleSide& one, const TriangleSide& other)
          { return std::tie(one.Low, one.High) < std::tie(other.Low, other.High); });
      if (distance < nearest && !areJoined)
      {
        nearest = distance;
        isFound = true;
      }
    });
  if (!isFound)
  {
    return "";
  }
  char number[32];
  const auto end =
    std::to_chars(number, number + sizeof(number), nearest, std::chars_format::general, 3).ptr;
  return " Points of these edges are only " + std::string(number, end) +
    " apart: if they are the same, merge them first (ParaView's filter Clean with this tolerance).";
}

} // namespace

std::vector<TriangleSide> SortSides(const PatchTriangles& surface)
{
  Groups<TriangleSide> groups = MakeGroups<TriangleSide>(surface.Points.size(),
    [&](const auto& visit)
    {
      for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
      {
        const PointTriangle& corners = surface.Triangles[t].Corners;
        for (int i = 0; i < 3; ++i)
        {
          const Index from = corners[i], to = corners[(i + 1) % 3], low = std::min(from, to);
          visit(low, TriangleSide{ low, std::max(from, to), static_cast<Index>(t), from < to });
        }
      }
    });
  for (std::size_t p = 0; p < surface.Points.size(); ++p)
  {
    const auto begin = groups.Items.begin();
    std::sort(begin + groups.Begin[p], begin + groups.Begin[p + 1],
      [](const TriangleSide& a, const TriangleSide& b)
      { return a.High != b.High ? a.High < b.High : a.Triangle < b.Triangle; });
  }
  return std::move(groups.Items);
}

std::vector<TriangleSide> FindOddEdges(const std::vector<TriangleSide>& sides)
{
  std::vector<TriangleSide> odd;
  ForEdges(sides,
    [&odd](auto first, auto last)
    {
      if ((last - first) % 2 == 1)
      {
        odd.push_back(*first);
      }
    });
  return odd;
}

void CheckEdges(const PatchTriangles& surface, const std::vector<TriangleSide>& sides)
{
  std::vector<TriangleSide> open, odd;
  Index most = 0;
  ForEdges(sides,
    [&](auto first, auto last)
    {
      const Index count = last - first;
      if (count % 2 == 1)
      {
        (count == 1 ? open : odd).push_back(*first);
        most = std::max(most, count);
      }
    });
  if (!open.empty())
  {
    throw InputError("The surface is open: " + std::to_string(open.size()) +
      " edges belong to one triangle only, the first " + FormatEdge(surface.Points, open.front()) +
      ". Close its holes first (ParaView's filter Fill Holes)." +
      HintAtWelding(surface.Points, open));
  }
  if (!odd.empty())
  {
    throw InputError("The surface is not manifold: " + std::to_string(odd.size()) +
      " edges belong to an odd number of triangles, up to " + std::to_string(most) +
      ", the first " + FormatEdge(surface.Points, odd.front()) +
      ". Remove the triangles inside of the body, or give each part in a file of its own.");
  }
}

} // namespace vfm
