#include "Surfaces/NestedParts.h"

#include "Base/BoxTree.h"
#include "Base/Groups.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace vfm
{
namespace
{

constexpr Index Samples = 9;            // of a component
constexpr int MostBins = 1024;          // along an axis
constexpr Index EntriesPerTriangle = 8; // in bins, on average

/// Bins of the triangles over y and z.
struct ColumnBins
{
  Vector3 Lower, Scale; ///< bins per length
  int Count = 1;        ///< along each axis
  Groups<Index> Triangles;

  int Find(int axis, double x) const
  {
    const double bin = std::floor((x - this->Lower[axis]) * this->Scale[axis]);
    return static_cast<int>(std::min(std::max(bin, 0.0), this->Count - 1.0));
  }
  Index FindBin(const Vector3& x) const
  {
    return static_cast<Index>(this->Find(2, x[2])) * this->Count + this->Find(1, x[1]);
  }
};

Bounds BoxOf(const PatchTriangles& surface, Index triangle)
{
  Bounds box;
  for (Index p : surface.Triangles[triangle].Corners)
  {
    box.Add(surface.Points[p]);
  }
  return box;
}

/// Calls visit(bin) for the bins that a box overlaps.
template <class Visitor>
void ForBins(const ColumnBins& bins, const Bounds& box, const Visitor& visit)
{
  const int lastY = bins.Find(1, box.Upper[1]), lastZ = bins.Find(2, box.Upper[2]);
  for (int z = bins.Find(2, box.Lower[2]); z <= lastZ; ++z)
  {
    for (int y = bins.Find(1, box.Lower[1]); y <= lastY; ++y)
    {
      visit(static_cast<Index>(z) * bins.Count + y);
    }
  }
}

/// Sets the number of bins along each axis.
void SetCount(const Bounds& all, int count, ColumnBins& bins)
{
  bins.Count = count;
  bins.Lower = all.Lower;
  for (int a = 0; a < 3; ++a)
  {
    const double scale = count / (all.Upper[a] - all.Lower[a]);
    bins.Scale[a] = std::isfinite(scale) ? scale : 0.0;
  }
}

ColumnBins MakeBins(const PatchTriangles& surface)
{
  const Index count = static_cast<Index>(surface.Triangles.size());
  Bounds all;
  for (const Vector3& x : surface.Points)
  {
    all.Add(x);
  }
  ColumnBins bins;
  Index entries = 0;
  int size = std::min(1 + static_cast<int>(std::sqrt(static_cast<double>(count))), MostBins);
  do // fewer bins if large triangles are in many of them
  {
    SetCount(all, size, bins);
    entries = 0;
    for (Index t = 0; t < count; ++t)
    {
      const Bounds box = BoxOf(surface, t);
      entries += Index(1 + bins.Find(1, box.Upper[1]) - bins.Find(1, box.Lower[1])) *
        (1 + bins.Find(2, box.Upper[2]) - bins.Find(2, box.Lower[2]));
    }
    size /= 2;
  } while (size > 0 && entries > EntriesPerTriangle * count);
  bins.Triangles = MakeGroups<Index>(static_cast<std::size_t>(bins.Count) * bins.Count,
    [&](const auto& visit)
    {
      for (Index t = 0; t < count; ++t)
      {
        ForBins(bins, BoxOf(surface, t), [&](Index bin) { visit(bin, t); });
      }
    });
  return bins;
}

/// Returns the turn, 1, -1 or 0, that the side from a point to another adds around a line along x.
/// Both directions of the side give opposite numbers, also with rounding.
int TurnOfSide(const std::vector<Vector3>& points, Index from, Index to, const Vector3& line)
{
  const Vector3 &low = points[std::min(from, to)], &high = points[std::max(from, to)];
  if ((low[1] > line[1]) == (high[1] > line[1]))
  {
    return 0;
  }
  const double part = (line[1] - low[1]) / (high[1] - low[1]);
  const bool isBeyond = low[2] + part * (high[2] - low[2]) > line[2];
  return !isBeyond ? 0 : (low[1] < high[1]) == (from < to) ? 1 : -1;
}

/// Returns the place along x where a line meets the plane of a triangle, inside of its range.
double FindMeeting(const PatchTriangles& surface, Index triangle, const Vector3& line)
{
  const PointTriangle& c = surface.Triangles[triangle].Corners;
  const Vector3 &a = surface.Points[c[0]], &b = surface.Points[c[1]], &d = surface.Points[c[2]];
  const Vector3 normal = Cross(b - a, d - a);
  const double x = a[0] - (normal[1] * (line[1] - a[1]) + normal[2] * (line[2] - a[2])) / normal[0];
  const Bounds box = BoxOf(surface, triangle);
  return std::isnan(x) ? box.Lower[0] : std::min(std::max(x, box.Lower[0]), box.Upper[0]);
}

/// Crossings of a line from a point along x with the components.
struct Crossings
{
  int Count = 0;       ///< behind the point
  bool IsNear = false; ///< one is close to the point
};

/// Votes of the samples of a component about another one.
struct Votes
{
  Index Inside = 0, Near = 0;
};

std::map<Index, Crossings> FindCrossings(const PatchTriangles& surface, const SurfaceParts& parts,
  const ColumnBins& bins, const Vector3& point, double distance)
{
  std::map<Index, Crossings> found;
  const Index bin = bins.FindBin(point);
  for (Index i = bins.Triangles.Begin[bin]; i < bins.Triangles.Begin[bin + 1]; ++i)
  {
    const Index triangle = bins.Triangles.Items[i];
    const PointTriangle& c = surface.Triangles[triangle].Corners;
    const int turn = TurnOfSide(surface.Points, c[0], c[1], point) +
      TurnOfSide(surface.Points, c[1], c[2], point) + TurnOfSide(surface.Points, c[2], c[0], point);
    if (turn != 0)
    {
      const double x = FindMeeting(surface, triangle, point);
      Crossings& crossings = found[parts.Part[triangle]];
      crossings.Count += x > point[0];
      crossings.IsNear = crossings.IsNear || std::fabs(x - point[0]) <= distance;
    }
  }
  return found;
}

Vector3 CentreOf(const PatchTriangles& surface, Index triangle)
{
  const PointTriangle& c = surface.Triangles[triangle].Corners;
  return (1.0 / 3.0) * (surface.Points[c[0]] + surface.Points[c[1]] + surface.Points[c[2]]);
}

bool IsWithin(const Bounds& inner, const Bounds& outer)
{
  bool isWithin = true;
  for (int a = 0; a < 3; ++a)
  {
    isWithin = isWithin && inner.Lower[a] >= outer.Lower[a] && inner.Upper[a] <= outer.Upper[a];
  }
  return isWithin;
}

std::vector<Bounds> BoxesOfParts(const PatchTriangles& surface, const SurfaceParts& parts)
{
  std::vector<Bounds> boxes(parts.Count);
  for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
  {
    boxes[parts.Part[t]].Add(BoxOf(surface, static_cast<Index>(t)));
  }
  return boxes;
}

} // namespace

std::vector<bool> FindCavities(
  const PatchTriangles& surface, const SurfaceParts& parts, double distance)
{
  std::vector<bool> areCavities(parts.Count, false);
  if (parts.Count < 2)
  {
    return areCavities;
  }
  const std::vector<Bounds> boxes = BoxesOfParts(surface, parts);
  const ColumnBins bins = MakeBins(surface);
  const Groups<Index> members = MakeGroups<Index>(parts.Count,
    [&](const auto& visit)
    {
      for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
      {
        visit(parts.Part[t], static_cast<Index>(t));
      }
    });
  for (Index p = 0; p < parts.Count; ++p)
  {
    const Index begin = members.Begin[p], count = members.Begin[p + 1] - begin;
    const Index samples = std::min(count, Samples);
    std::map<Index, Votes> votes;
    for (Index s = 0; s < samples; ++s)
    {
      const Vector3 point = CentreOf(surface, members.Items[begin + s * count / samples]);
      for (const auto& [other, crossings] : FindCrossings(surface, parts, bins, point, distance))
      {
        if (other != p && IsWithin(boxes[p], boxes[other]))
        {
          votes[other].Near += crossings.IsNear;
          votes[other].Inside += !crossings.IsNear && crossings.Count % 2 == 1;
        }
      }
    }
    for (const auto& [other, vote] : votes)
    {
      areCavities[p] = areCavities[p] != (2 * vote.Inside > samples - vote.Near);
    }
  }
  return areCavities;
}

} // namespace vfm
