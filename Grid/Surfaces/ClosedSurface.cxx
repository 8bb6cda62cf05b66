#include "Surfaces/ClosedSurface.h"

#include "Ranks/Errors.h"
#include "Surfaces/NestedParts.h"
#include "Surfaces/RepeatedTriangles.h"
#include "Surfaces/SplitEdges.h"
#include "Surfaces/WeldPoints.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vfm
{
namespace
{

// Largest coordinate of a grid (CartesianGrid); volumes and areas stay in the range of double.
constexpr double LargestCoordinate = 1e60;
constexpr double WeldDistance = 1e-6; // of the diagonal

void CheckPoints(const std::vector<Vector3>& points, const std::vector<PointTriangle>& triangles)
{
  const Index count = static_cast<Index>(points.size());
  for (const PointTriangle& triangle : triangles)
  {
    for (Index p : triangle)
    {
      if (p < 0 || p >= count)
      {
        throw InputError("A triangle refers to point " + std::to_string(p) + ", but there are " +
          std::to_string(count) + " points.");
      }
      const Vector3& x = points[p];
      if (!std::isfinite(x[0]) || !std::isfinite(x[1]) || !std::isfinite(x[2]))
      {
        throw InputError("The point " + std::to_string(p) + " of the surface is not finite.");
      }
      if (std::max({ std::abs(x[0]), std::abs(x[1]), std::abs(x[2]) }) > LargestCoordinate)
      {
        throw InputError("The point " + std::to_string(p) +
          " of the surface has a coordinate beyond 1e60. Scale the coordinates: use another unit "
          "of length.");
      }
    }
  }
}

std::vector<PatchTriangle> WithPatches(
  const std::vector<PointTriangle>& triangles, const std::vector<int>* patches)
{
  std::vector<PatchTriangle> all;
  all.reserve(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    all.push_back({ triangles[t], patches ? (*patches)[t] : 0 });
  }
  return all;
}

/// Adds a sentence to a note if the count is not 0: the count and a text.
void AddNote(Index count, const std::string& text, std::string& note)
{
  if (count > 0)
  {
    note += (note.empty() ? "" : " ") + std::to_string(count) + " " + text;
  }
}

void AddDropped(const DroppedTriangles& dropped, std::string& note)
{
  AddNote(dropped.Repeated, "repeated triangles are dropped.", note);
  AddNote(
    dropped.BackToBack, "triangles that lie back to back, inside of the body, are dropped.", note);
}

/// Merges points, drops repeated triangles and divides edges, until all edges are closed if
/// possible.
/// @return sides of the triangles
std::vector<TriangleSide> Repair(double distance, PatchTriangles& surface, std::string& note)
{
  AddDropped(DropRepeated(surface), note);
  std::vector<TriangleSide> sides = SortSides(surface);
  const std::vector<TriangleSide> open = FindOddEdges(sides);
  if (open.empty() || !(distance > 0.0))
  {
    return sides;
  }
  const Index welded = WeldPoints(distance, open, surface);
  AddNote(welded, "points are merged with others within 1e-6 of the size.", note);
  surface = SortTriangles(surface.Points, std::move(surface.Triangles));
  AddDropped(DropRepeated(surface), note);
  const Index divided = SplitOpenEdges(distance, surface);
  AddNote(divided, "triangles are divided, because corners of others lie on their edges.", note);
  return SortSides(surface);
}

/// Returns six times the volume inside of each part if its triangles are turned as its first one.
std::vector<double> MeasureParts(const PatchTriangles& surface, const SurfaceParts& parts)
{
  std::vector<double> volumes(parts.Count, 0.0);
  std::vector<Index> first(parts.Count, -1);
  for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
  {
    const PointTriangle& c = surface.Triangles[t].Corners;
    Index& origin = first[parts.Part[t]];
    origin = origin < 0 ? c[0] : origin;
    const Vector3& from = surface.Points[origin];
    const double volume = Dot(
      surface.Points[c[0]] - from, Cross(surface.Points[c[1]] - from, surface.Points[c[2]] - from));
    volumes[parts.Part[t]] += parts.IsTurned[t] ? -volume : volume;
  }
  return volumes;
}

/// Numbers of triangles of a part, or of all parts but cavities.
struct TurnCount
{
  Index Turned = 0, Kept = 0;
};

/// Reports turned triangles, unless the whole surface faces the wrong way.
void AddTurned(const std::vector<TurnCount>& counts, const std::vector<bool>& areCavities,
  const std::vector<Vector3>& places, std::string& note)
{
  TurnCount all;
  for (std::size_t p = 0; p < counts.size(); ++p)
  {
    all.Turned += areCavities[p] ? 0 : counts[p].Turned;
    all.Kept += areCavities[p] ? 0 : counts[p].Kept;
  }
  const bool isReversed = all.Turned > all.Kept;
  Index parts = 0, cavities = 0, triangles = 0;
  std::string first;
  for (std::size_t p = 0; p < counts.size(); ++p)
  {
    const Index turned = isReversed ? counts[p].Kept : counts[p].Turned;
    const bool isWhole = turned == counts[p].Kept + counts[p].Turned;
    first = turned > 0 && first.empty() ? FormatPlace(places[p]) : first;
    (!isWhole ? triangles : areCavities[p] ? cavities : parts) += isWhole ? 1 : turned;
  }
  AddNote(parts, "components of the surface that faced inwards are turned.", note);
  AddNote(cavities,
    "components inside of others, which did not face inwards, are taken as walls of cavities; "
    "give bodies inside of others in files of their own.",
    note);
  AddNote(triangles, "triangles that faced the other way than their neighbours are turned.", note);
  note += first.empty() ? "" : " The first place is " + first + ".";
}

/// Turns the triangles outwards, those of cavities inwards.
void TurnOutwards(const SurfaceParts& parts, const std::vector<bool>& areCavities,
  PatchTriangles& surface, std::string& note)
{
  const std::vector<double> volumes = MeasureParts(surface, parts);
  std::vector<TurnCount> counts(parts.Count);
  std::vector<Vector3> places(parts.Count);
  for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
  {
    const Index part = parts.Part[t];
    const bool isPartTurned = (volumes[part] < 0.0) != areCavities[part];
    PatchTriangle& triangle = surface.Triangles[t];
    TurnCount& count = counts[part];
    if (count.Turned + count.Kept == 0)
    {
      places[part] = surface.Points[triangle.Corners[0]];
    }
    if (parts.IsTurned[t] != isPartTurned)
    {
      triangle.Turn();
      ++count.Turned;
    }
    else
    {
      ++count.Kept;
    }
  }
  AddTurned(counts, areCavities, places, note);
}

} // namespace

std::vector<Triangle> PlaceTriangles(const ClosedSurface& surface)
{
  std::vector<Triangle> placed;
  placed.reserve(surface.Triangles.size());
  for (const PointTriangle& t : surface.Triangles)
  {
    placed.push_back({ { surface.Points[t[0]], surface.Points[t[1]], surface.Points[t[2]] } });
  }
  return placed;
}

double MeasureVolume(const ClosedSurface& surface)
{
  const Vector3 origin =
    surface.Triangles.empty() ? Vector3{} : surface.Points[surface.Triangles[0][0]];
  double sum = 0.0;
  for (const Triangle& t : PlaceTriangles(surface))
  {
    sum += Dot(t[0] - origin, Cross(t[1] - origin, t[2] - origin)) / 6.0;
  }
  return sum;
}

ClosedSurface CloseSurface(std::vector<Vector3> points, std::vector<PointTriangle> triangles,
  std::vector<int>* patches, std::string* note)
{
  CheckPoints(points, triangles);
  PatchTriangles surface = SortTriangles(points, WithPatches(triangles, patches));
  const double distance = WeldDistance * FindDiagonal(surface.Points);
  std::string repairs;
  const std::vector<TriangleSide> sides = Repair(distance, surface, repairs);
  if (surface.Triangles.empty())
  {
    throw InputError("The surface has no polygons.");
  }
  CheckEdges(surface, sides);
  const SurfaceParts parts = FindParts(surface, sides);
  TurnOutwards(parts, FindCavities(surface, parts, distance), surface, repairs);
  surface = SortTriangles(surface.Points, std::move(surface.Triangles));
  ClosedSurface closed{ std::move(surface.Points), {} };
  if (patches)
  {
    patches->clear();
  }
  for (const PatchTriangle& triangle : surface.Triangles)
  {
    closed.Triangles.push_back(triangle.Corners);
    if (patches)
    {
      patches->push_back(triangle.Patch);
    }
  }
  if (note)
  {
    *note = repairs;
  }
  return closed;
}

} // namespace vfm
