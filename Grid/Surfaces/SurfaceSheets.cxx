#include "Surfaces/SurfaceSheets.h"

#include "Base/BoxTree.h"
#include "Base/DisjointSets.h"
#include "Base/PortableMath.h"
#include "Base/Sorted.h"

#include <algorithm>
#include <cmath>

namespace vfm
{
namespace
{

constexpr double NeedleHeight = 1e-5; // in sizes of the surface; below, normals are rounding errors

/// Edge of one triangle.
struct Wing
{
  std::array<Index, 2> Points; // the lower number first
  Index Triangle;
  bool IsForward; // the triangle runs from Points[0] to Points[1]
};

/// Two triangles that are neighbours across an edge.
struct Hinge
{
  std::array<Index, 2> Points;
  std::array<Index, 2> Triangles; // the first one runs from Points[0] to Points[1]
};

std::vector<Wing> ListWings(const ClosedSurface& surface)
{
  std::vector<Wing> wings;
  wings.reserve(3 * surface.Triangles.size());
  for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
  {
    for (int c = 0; c < 3; ++c)
    {
      const Index from = surface.Triangles[t][c], to = surface.Triangles[t][(c + 1) % 3];
      wings.push_back(
        { { { std::min(from, to), std::max(from, to) } }, static_cast<Index>(t), from < to });
    }
  }
  std::stable_sort(
    wings.begin(), wings.end(), [](const Wing& a, const Wing& b) { return a.Points < b.Points; });
  return wings;
}

/// Returns the corner of a triangle beside an edge.
Vector3 Apex(const ClosedSurface& surface, const Wing& wing)
{
  const PointTriangle& corners = surface.Triangles[wing.Triangle];
  const auto apex = std::find_if(corners.begin(), corners.end(),
    [&](Index p) { return p != wing.Points[0] && p != wing.Points[1]; });
  return surface.Points[*apex];
}

/// Returns a number in [0, 4) that increases with the angle of (x, y) from the x axis.
double Turn(double x, double y)
{
  const double part = std::abs(x) + std::abs(y);
  const double along = part > 0.0 ? y / part : 0.0;
  return x < 0.0 ? 2.0 - along : y < 0.0 ? 4.0 + along : along;
}

/// Sorts the triangles around an edge by their angle, turning about its direction. Of two triangles
/// at one angle, the forward one is first: nothing is between them.
void SortAround(const ClosedSurface& surface, std::vector<Wing>& wings)
{
  const Vector3 start = surface.Points[wings[0].Points[0]];
  const Vector3 along = surface.Points[wings[0].Points[1]] - start;
  const Vector3 x = Cross(Apex(surface, wings[0]) - start, along), y = Cross(along, x);
  const double ratio = Norm(y) / std::max(Norm(x), 1e-300);
  std::vector<std::pair<double, Wing>> turns;
  for (const Wing& wing : wings)
  {
    const Vector3 side = Apex(surface, wing) - start;
    turns.emplace_back(Turn(ratio * Dot(side, x), Dot(side, y)), wing);
  }
  std::stable_sort(turns.begin(), turns.end(),
    [](const auto& a, const auto& b)
    { return a.first != b.first ? a.first < b.first : a.second.IsForward > b.second.IsForward; });
  std::transform(turns.begin(), turns.end(), wings.begin(), [](const auto& t) { return t.second; });
}

/// Adds the pairs of neighbours around an edge. The solid lies between a backward triangle and the
/// next forward one.
void PairAround(const ClosedSurface& surface, std::vector<Wing> wings, std::vector<Hinge>& hinges)
{
  if (wings.size() > 2)
  {
    SortAround(surface, wings);
  }
  std::vector<Wing> open;
  const std::size_t count = wings.size();
  for (std::size_t w = 0; w < 2 * count; ++w) // twice around: solid may lie across the first angle
  {
    Wing& wing = wings[w % count];
    if (wing.Triangle >= 0 && wing.IsForward && !open.empty())
    {
      hinges.push_back({ wing.Points, { { wing.Triangle, open.back().Triangle } } });
      open.pop_back();
      wing.Triangle = -1;
    }
    else if (wing.Triangle >= 0 && !wing.IsForward && w < count)
    {
      open.push_back(wing);
    }
  }
}

std::vector<Hinge> FindHinges(const ClosedSurface& surface)
{
  const std::vector<Wing> wings = ListWings(surface);
  std::vector<Hinge> hinges;
  hinges.reserve(wings.size() / 2);
  ForRuns(
    wings.begin(), wings.end(), [](const Wing& a, const Wing& b) { return a.Points == b.Points; },
    [&](auto first, auto last) {
      PairAround(surface, { first, last }, hinges);
    });
  return hinges;
}

double LengthOf(const ClosedSurface& surface, const Hinge& hinge)
{
  return Norm(surface.Points[hinge.Points[1]] - surface.Points[hinge.Points[0]]);
}

/// Triangles with their normals.
struct Normals
{
  std::vector<Vector3> Of;    // unit
  std::vector<bool> IsNeedle; // Of is not known
};

Normals MeasureNormals(const ClosedSurface& surface)
{
  Bounds box;
  for (const PointTriangle& triangle : surface.Triangles)
  {
    for (Index p : triangle)
    {
      box.Add(surface.Points[p]);
    }
  }
  const double least = NeedleHeight * Norm(box.Upper - box.Lower);
  Normals normals;
  for (const PointTriangle& t : surface.Triangles)
  {
    const Vector3 a = surface.Points[t[1]] - surface.Points[t[0]];
    const Vector3 b = surface.Points[t[2]] - surface.Points[t[0]];
    const Vector3 area = Cross(a, b);
    const double longest = std::max({ Norm(a), Norm(b), Norm(b - a) });
    normals.IsNeedle.push_back(!(Norm(area) > least * longest));
    normals.Of.push_back(normals.IsNeedle.back() ? Vector3{} : (1.0 / Norm(area)) * area);
  }
  return normals;
}

/// Gives needles the normals of triangles beyond their longest edges.
/// @return whether each hinge joins a needle with the triangle whose normal it has
std::vector<bool> JoinNeedles(
  const ClosedSurface& surface, const std::vector<Hinge>& hinges, Normals& normals)
{
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t h = 0; h < hinges.size(); ++h)
  {
    const auto [a, b] = hinges[h].Triangles;
    if (normals.IsNeedle[a] || normals.IsNeedle[b])
    {
      order.emplace_back(-LengthOf(surface, hinges[h]), h);
    }
  }
  std::sort(order.begin(), order.end());
  std::vector<Index> sets = MakeSets(surface.Triangles.size());
  std::vector<Index> source(sets.size()); // of each root: a triangle with a normal, or -1
  for (std::size_t t = 0; t < sets.size(); ++t)
  {
    source[t] = normals.IsNeedle[t] ? -1 : static_cast<Index>(t);
  }
  std::vector<bool> isJoined(hinges.size(), false);
  for (const auto& [length, h] : order)
  {
    const Index a = FindRoot(sets, hinges[h].Triangles[0]);
    const Index b = FindRoot(sets, hinges[h].Triangles[1]);
    if (a != b && (source[a] < 0 || source[b] < 0))
    {
      const Index known = std::max(source[a], source[b]);
      Join(sets, a, b);
      source[FindRoot(sets, a)] = known;
      isJoined[h] = true;
    }
  }
  for (std::size_t t = 0; t < sets.size(); ++t)
  {
    const Index from = source[FindRoot(sets, static_cast<Index>(t))];
    normals.Of[t] = from >= 0 ? normals.Of[from] : Vector3{};
  }
  return isJoined;
}

/// Numbers the sets from 0 by their lowest triangles.
std::vector<int> NumberSets(std::vector<Index>& sets)
{
  std::vector<int> numbers(sets.size());
  int count = 0;
  for (std::size_t t = 0; t < sets.size(); ++t)
  {
    const Index root = FindRoot(sets, static_cast<Index>(t)); // the lowest of the set
    numbers[t] = root == static_cast<Index>(t) ? count++ : numbers[root];
  }
  return numbers;
}

std::vector<SharpCorner> FindCorners(const SurfaceSheets& sheets)
{
  std::vector<std::pair<Index, int>> meetings; // of points and sheets
  for (const SharpEdge& edge : sheets.Edges)
  {
    for (Index triangle : edge.Triangles)
    {
      meetings.emplace_back(edge.Points[0], sheets.SheetOf[triangle]);
      meetings.emplace_back(edge.Points[1], sheets.SheetOf[triangle]);
    }
  }
  SortUnique(meetings);
  std::vector<SharpCorner> corners;
  ForRuns(
    meetings.begin(), meetings.end(),
    [](const auto& a, const auto& b) { return a.first == b.first; },
    [&](auto first, auto last)
    {
      if (last - first > 2)
      {
        corners.push_back({ first->first, {} });
        std::transform(first, last, std::back_inserter(corners.back().Sheets),
          [](const auto& meeting) { return meeting.second; });
      }
    });
  return corners;
}

} // namespace

SurfaceSheets FindSheets(const ClosedSurface& surface, double angleDegrees)
{
  const std::vector<Hinge> hinges = FindHinges(surface);
  Normals normals = MeasureNormals(surface);
  const std::vector<bool> isJoined = JoinNeedles(surface, hinges, normals);
  const double leastCosine = Cosine(angleDegrees * (Pi / 180.0));
  std::vector<Index> sets = MakeSets(surface.Triangles.size());
  SurfaceSheets sheets;
  for (std::size_t h = 0; h < hinges.size(); ++h)
  {
    const auto [a, b] = hinges[h].Triangles;
    if (isJoined[h] || Dot(normals.Of[a], normals.Of[b]) >= leastCosine)
    {
      Join(sets, a, b);
      continue;
    }
    const Vector3 along = surface.Points[hinges[h].Points[1]] - surface.Points[hinges[h].Points[0]];
    const bool isConvex = Dot(Cross(normals.Of[a], normals.Of[b]), along) > 0.0;
    sheets.Edges.push_back({ hinges[h].Points, hinges[h].Triangles, isConvex });
  }
  sheets.SheetOf = NumberSets(sets);
  sheets.Normals = std::move(normals.Of);
  sheets.Corners = FindCorners(sheets);
  return sheets;
}

} // namespace vfm
