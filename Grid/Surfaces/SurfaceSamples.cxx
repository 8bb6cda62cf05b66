#include "Surfaces/SurfaceSamples.h"

#include "Base/DisjointSets.h"
#include "Base/Groups.h"
#include "Base/Vector3.h"

#include <algorithm>
#include <cmath>

namespace vfm
{
namespace
{

constexpr int LeastSamples = 24; // of a component

/// Returns the digits of a number in base 2 behind the point, reversed (van der Corput).
double ReverseDigits(Index number)
{
  double value = 0.0, digit = 0.5;
  for (; number > 0; number /= 2, digit *= 0.5)
  {
    value += number % 2 == 1 ? digit : 0.0;
  }
  return value;
}

/// Returns a point of a triangle, not a corner.
/// @param u, v  in [0,1]; equally distributed pairs give equally distributed points
Vector3 PointOf(const Triangle& t, double u, double v)
{
  const double root = std::sqrt(0.001 + 0.998 * u);
  return t[0] + root * (1.0 - v) * (t[1] - t[0]) + root * v * (t[2] - t[0]);
}

/// Appends samples of equal area of some triangles.
void AddSamples(const std::vector<Triangle>& corners, const std::vector<double>& areas,
  const int* first, const int* last, int count, std::vector<SurfaceSample>& samples)
{
  double total = 0.0;
  for (const int* t = first; t != last; ++t)
  {
    total += areas[*t];
  }
  double before = 0.0;
  int number = 0;
  for (const int* t = first; t != last; ++t)
  {
    const double end = before + areas[*t];
    for (; number < count && (number + 0.5) / count * total < end; ++number)
    {
      const double u = ((number + 0.5) / count * total - before) / areas[*t];
      const Triangle& corner = corners[*t];
      samples.push_back({ PointOf(corner, u, ReverseDigits(number + 1)),
        Unit(Cross(corner[1] - corner[0], corner[2] - corner[0])), total / count, *t });
    }
    before = end;
  }
}

} // namespace

SurfaceComponents FindComponents(const ClosedSurface& surface)
{
  std::vector<Index> sets = MakeSets(surface.Points.size());
  for (const PointTriangle& t : surface.Triangles)
  {
    Join(sets, t[0], t[1]);
    Join(sets, t[0], t[2]);
  }
  SurfaceComponents components;
  std::vector<int> ofRoot(surface.Points.size(), -1);
  const std::vector<Triangle> corners = PlaceTriangles(surface);
  for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
  {
    int& component = ofRoot[FindRoot(sets, surface.Triangles[t][0])];
    if (component < 0)
    {
      component = static_cast<int>(components.Volumes.size());
      components.Volumes.push_back(0.0);
    }
    components.OfTriangle.push_back(component);
    const Vector3 &origin = corners[0][0], a = corners[t][0] - origin, b = corners[t][1] - origin,
                  c = corners[t][2] - origin;
    components.Volumes[component] += Dot(a, Cross(b, c)) / 6.0;
  }
  components.Solids = static_cast<int>(std::count_if(components.Volumes.begin(),
    components.Volumes.end(), [](double volume) { return volume > 0.0; }));
  return components;
}

double MeasureArea(const ClosedSurface& surface)
{
  double area = 0.0;
  for (const Triangle& t : PlaceTriangles(surface))
  {
    area += 0.5 * Norm(Cross(t[1] - t[0], t[2] - t[0]));
  }
  return area;
}

std::vector<SurfaceSample> SampleSurface(
  const ClosedSurface& surface, const SurfaceComponents& components, int count)
{
  const std::vector<Triangle> corners = PlaceTriangles(surface);
  std::vector<double> areas, ofComponent(components.Volumes.size(), 0.0);
  double total = 0.0;
  for (std::size_t t = 0; t < corners.size(); ++t)
  {
    areas.push_back(
      0.5 * Norm(Cross(corners[t][1] - corners[t][0], corners[t][2] - corners[t][0])));
    ofComponent[components.OfTriangle[t]] += areas.back();
    total += areas.back();
  }
  const Groups<int> members = MakeGroups<int>(ofComponent.size(),
    [&](const auto& visit)
    {
      for (std::size_t t = 0; t < corners.size(); ++t)
      {
        visit(components.OfTriangle[t], static_cast<int>(t));
      }
    });
  std::vector<SurfaceSample> samples;
  for (std::size_t c = 0; c < ofComponent.size(); ++c)
  {
    const int share = static_cast<int>(std::ceil(count * ofComponent[c] / total));
    AddSamples(corners, areas, members.Items.data() + members.Begin[c],
      members.Items.data() + members.Begin[c + 1], std::max(share, LeastSamples), samples);
  }
  return samples;
}

} // namespace vfm
