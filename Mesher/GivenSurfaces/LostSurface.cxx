#include "GivenSurfaces/LostSurface.h"

#include "Base/BoxTree.h"
#include "Base/DisjointSets.h"
#include "Base/Groups.h"
#include "Elements/GridCoordinates.h"
#include "Surfaces/SurfaceThickness.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <utility>

namespace vfm
{
namespace
{

constexpr int SamplesOfAll = 16384, LeastSamples = 1024; // of all bodies, of one
constexpr std::size_t Stride = 4; // thickness is measured at each sample of this number
// Distance from the surface at which cells below and above it are looked for, in cells.
constexpr double DepthOfCell = 1e-3;
// Distances to the mesh, in cells, at which samples are near, and at which they are not far: edges
// of less than 20 degrees recede by up to two cells.
constexpr double NearReach = 1.0, FarReach = 2.5;
// Samples closer than this times the side of the square for which one stands are of one part.
constexpr double Spacing = 3.0;

/// Samples of a body and what is known of them.
struct SampledBody
{
  SurfaceComponents Components;
  std::vector<SurfaceSample> Samples;
  std::unique_ptr<const TriangleSearch> Search;
  ///@{ Known on this rank, later on any rank.
  std::vector<unsigned char> IsPresent, IsNear;
  std::vector<unsigned char> IsNotFar; ///< only of lost samples
  ///@}

  bool IsLost(std::size_t s) const { return this->IsPresent[s] && !this->IsNear[s]; }
};

using Flags = std::vector<unsigned char> SampledBody::*;

std::vector<SampledBody> SampleBodies(const BodySurfaces& surfaces, Runtime& runtime)
{
  std::vector<double> areas;
  double total = 0.0;
  for (const GivenBody& body : surfaces.Bodies())
  {
    areas.push_back(MeasureArea(body.Boundary));
    total += areas.back();
  }
  std::vector<SampledBody> bodies;
  for (std::size_t b = 0; b < areas.size(); ++b)
  {
    const ClosedSurface& surface = surfaces.Bodies()[b].Boundary;
    SampledBody body;
    body.Components = FindComponents(surface);
    const int count = static_cast<int>(SamplesOfAll * areas[b] / total);
    body.Samples = SampleSurface(surface, body.Components, std::max(count, LeastSamples));
    body.Search = std::make_unique<const TriangleSearch>(PlaceTriangles(surface), runtime);
    body.IsPresent.assign(body.Samples.size(), 0);
    body.IsNear.assign(body.Samples.size(), 0);
    body.IsNotFar.assign(body.Samples.size(), 0);
    bodies.push_back(std::move(body));
  }
  return bodies;
}

/// Returns the thickness that a share of the area of samples does not exceed.
double MeasureQuantile(const std::vector<SurfaceSample>& samples, const SampledBody& body,
  double share, Runtime& runtime)
{
  const std::vector<double> thickness =
    MeasureThickness(samples, *body.Search, BallSide::Inner, runtime);
  // A tetrahedron has no opposed normals.
  return std::min(FindQuantile(samples, thickness, share), body.Search->Diagonal());
}

/// Finds the samples of the owned cells on the surface of the material: its cells below the surface
/// have some of it, and those above are not filled by it.
void FindPresent(int material, const CartesianGrid& grid, const FractionField& fractions,
  Runtime& runtime, SampledBody& body)
{
  const Vector3 origin = grid.NodePoint({ { 0, 0, 0 } });
  ForEach(runtime, body.Samples.size(),
    [&](Index s)
    {
      const SurfaceSample& sample = body.Samples[s];
      const auto cellAt = [&](double height)
      { return grid.CellAt(origin + grid.MeanWidth() * (sample.Point + height * sample.Normal)); };
      const Index3 below = cellAt(-DepthOfCell), above = cellAt(DepthOfCell);
      const auto fractionIn = [&](const Index3& cell) {
        return grid.Local().Contains(cell) ? fractions.Fraction(grid.Linear(cell), material) : 0.0;
      };
      body.IsPresent[s] = grid.Owned().Contains(below) && fractionIn(below) > 0.0 &&
        fractionIn(above) < 1.0 - FractionTolerance;
    });
}

/// Samples of a body, sorted into unit bins.
class SampleBins
{
public:
  /// @param selects  selects(sample) returns whether a sample is in the bins
  template <class Selects>
  SampleBins(const std::vector<SurfaceSample>& samples, const Selects& selects)
  {
    for (std::size_t s = 0; s < samples.size(); ++s)
    {
      if (selects(s))
      {
        const Index3 bin = BinOf(samples[s].Point);
        this->Entries.push_back({ { { bin[2], bin[1], bin[0] } }, static_cast<Index>(s) });
      }
    }
    std::sort(this->Entries.begin(), this->Entries.end());
  }
  /// Calls visit(sample) for the samples in the bins that a box touches.
  template <class Visit>
  void ForSamples(const Bounds& box, const Visit& visit) const
  {
    const Index3 low = BinOf(box.Lower), high = BinOf(box.Upper);
    for (Index z = low[2]; z <= high[2]; ++z)
    {
      for (Index y = low[1]; y <= high[1]; ++y)
      {
        const Entry first{ { { z, y, low[0] } }, 0 };
        const Index3 last{ { z, y, high[0] } };
        auto at = std::lower_bound(this->Entries.begin(), this->Entries.end(), first);
        for (; at != this->Entries.end() && at->first <= last; ++at)
        {
          visit(at->second);
        }
      }
    }
  }

private:
  using Entry = std::pair<Index3, Index>; // bin along z, y, x, and sample
  static Index3 BinOf(const Vector3& x)
  {
    return { { static_cast<Index>(std::floor(x[0])), static_cast<Index>(std::floor(x[1])),
      static_cast<Index>(std::floor(x[2])) } };
  }
  std::vector<Entry> Entries;
};

/// Facet in grid coordinates, as one or two triangles.
struct PlacedFacet
{
  std::vector<Triangle> Triangles;
  double Reach = 1.0;
  Bounds Box; ///< around all points within the reach

  /// @param reach  over the longest edge, or over a cell
  PlacedFacet(const CartesianGrid& grid, const Mesh& mesh, Index facet, double reach)
  {
    const int corners = mesh.CornersOfFacet();
    std::vector<Vector3> x;
    for (int c = 0; c < corners; ++c)
    {
      const Index point = mesh.Surfaces.Points[corners * facet + c];
      x.push_back(ToGrid(grid, mesh.Points.data() + 3 * point));
      this->Box.Add(x.back());
    }
    for (int c = 0; c < corners; ++c)
    {
      this->Reach = std::max(this->Reach, Norm(x[(c + 1) % corners] - x[c]));
    }
    for (int c = 1; c + 1 < corners; ++c)
    {
      this->Triangles.push_back({ { x[0], x[c], x[c + 1] } });
    }
    this->Reach *= reach;
    const Vector3 around{ { this->Reach, this->Reach, this->Reach } };
    this->Box = { this->Box.Lower - around, this->Box.Upper + around };
  }
  bool IsNear(const Vector3& x) const
  {
    return std::any_of(this->Triangles.begin(), this->Triangles.end(),
      [&](const Triangle& t)
      {
        const Vector3 away = NearestPoint(t, x) - x;
        return Dot(away, away) <= this->Reach * this->Reach;
      });
  }
};

/// Flags the samples that facets of their material reach.
void FindReached(const BodySurfaces& surfaces, const CartesianGrid& grid, const Mesh& mesh,
  const std::vector<SampleBins>& bins, double reach, Flags flags, Runtime& runtime,
  std::vector<SampledBody>& bodies)
{
  using Hit = std::pair<int, Index>; // body and sample
  const SurfaceFacets& facets = mesh.Surfaces;
  const std::vector<Hit> hits = CollectItems<Hit>(runtime, facets.SurfaceId.size(), 256,
    [&](Index f, std::vector<Hit>& found)
    {
      const PlacedFacet facet(grid, mesh, f, reach);
      for (int side = 0; side < 2; ++side)
      {
        const int body = surfaces.Find(facets.MaterialPair[2 * f + side]);
        if (body >= 0)
        {
          bins[body].ForSamples(facet.Box,
            [&](Index s)
            {
              if (facet.IsNear(bodies[body].Samples[s].Point))
              {
                found.push_back({ body, s });
              }
            });
        }
      }
    });
  for (const auto& [body, sample] : hits)
  {
    (bodies[body].*flags)[sample] = 1;
  }
}

/// Replaces the flags of samples by those of any rank.
void ShareFlags(Flags flags, Ranks& ranks, std::vector<SampledBody>& bodies)
{
  std::vector<std::int64_t> counts;
  for (const SampledBody& body : bodies)
  {
    counts.insert(counts.end(), (body.*flags).begin(), (body.*flags).end());
  }
  ranks.Sum(counts);
  auto at = counts.begin();
  for (SampledBody& body : bodies)
  {
    for (unsigned char& flag : body.*flags)
    {
      flag = *at++ > 0 ? 1 : 0;
    }
  }
}

/// Sets the counts of solids.
void CountSolids(const SampledBody& body, MeshReport::Body& report)
{
  const std::size_t components = body.Components.Volumes.size();
  std::vector<unsigned char> isPresent(components, 0), isNear(components, 0);
  for (std::size_t s = 0; s < body.Samples.size(); ++s)
  {
    const int component = body.Components.OfTriangle[body.Samples[s].Triangle];
    isPresent[component] |= body.IsPresent[s];
    isNear[component] |= body.IsNear[s];
  }
  for (std::size_t c = 0; c < components; ++c)
  {
    const bool isSolid = body.Components.Volumes[c] > 0.0 && isPresent[c];
    report.Solids += isSolid;
    report.LostSolids += isSolid && !isNear[c];
  }
}

/// Connected part of the lost surface.
struct LostPart
{
  std::vector<Index> Samples;
  double Area = 0.0;
  bool IsFar = false; ///< a sample is farther than FarReach
};

/// Returns the connected parts of the lost surface.
std::vector<LostPart> FindLostParts(const SampledBody& body)
{
  std::vector<Index> lost;
  std::vector<Bounds> boxes;
  for (std::size_t s = 0; s < body.Samples.size(); ++s)
  {
    if (body.IsLost(s))
    {
      const SurfaceSample& sample = body.Samples[s];
      const double reach = 0.5 * std::max(NearReach, Spacing * std::sqrt(sample.Area));
      const Vector3 half{ { reach, reach, reach } };
      lost.push_back(static_cast<Index>(s));
      boxes.push_back({ sample.Point - half, sample.Point + half });
    }
  }
  std::vector<Index> sets = MakeSets(lost.size());
  Runtime serial;
  BoxTree(boxes, serial).ForPairs(serial, [&](Index a, Index b) { Join(sets, a, b); });
  std::map<Index, LostPart> parts; // by root
  for (std::size_t i = 0; i < lost.size(); ++i)
  {
    LostPart& part = parts[FindRoot(sets, static_cast<Index>(i))];
    part.Samples.push_back(lost[i]);
    part.Area += body.Samples[lost[i]].Area;
    part.IsFar = part.IsFar || !body.IsNotFar[lost[i]];
  }
  std::vector<LostPart> all;
  for (auto& [root, part] : parts)
  {
    all.push_back(std::move(part));
  }
  return all;
}

/// Describes a lost part of the surface.
void DescribePart(const SampledBody& body, const LostPart& part, const CartesianGrid& grid,
  Runtime& runtime, MeshReport::Body& report)
{
  Bounds box;
  std::vector<SurfaceSample> samples;
  for (Index s : part.Samples)
  {
    samples.push_back(body.Samples[s]);
    box.Add(samples.back().Point);
  }
  report.LostArea = part.IsFar ? part.Area : 0.0;
  report.LostLength = Norm(box.Upper - box.Lower);
  report.LostThickness = MeasureQuantile(samples, body, 0.5, runtime);
  const Vector3 middle = 0.5 * (box.Lower + box.Upper);
  const auto nearest = std::min_element(samples.begin(), samples.end(),
    [&middle](const SurfaceSample& a, const SurfaceSample& b)
    { return Norm(a.Point - middle) < Norm(b.Point - middle); });
  report.LostPlace = grid.NodePoint({ { 0, 0, 0 } }) + grid.MeanWidth() * nearest->Point;
}

MeshReport::Body ReportBody(const SampledBody& body, const CartesianGrid& grid, Runtime& runtime)
{
  MeshReport::Body report;
  std::vector<SurfaceSample> sparse;
  for (std::size_t s = 0; s < body.Samples.size(); s += Stride)
  {
    sparse.push_back(body.Samples[s]);
  }
  report.Thickness = MeasureQuantile(sparse, body, ThinShare, runtime);
  double present = 0.0, lost = 0.0;
  for (std::size_t s = 0; s < body.Samples.size(); ++s)
  {
    present += body.IsPresent[s] ? body.Samples[s].Area : 0.0;
    lost += body.IsLost(s) ? body.Samples[s].Area : 0.0;
    report.IsWhole = report.IsWhole && body.IsPresent[s];
  }
  report.LostShare = present > 0.0 ? lost / present : 0.0;
  CountSolids(body, report);
  LostPart largest;
  for (LostPart& part : FindLostParts(body))
  {
    if (std::pair(part.IsFar, part.Area) > std::pair(largest.IsFar, largest.Area))
    {
      largest = std::move(part);
    }
  }
  if (!largest.Samples.empty())
  {
    DescribePart(body, largest, grid, runtime, report);
  }
  return report;
}

} // namespace

std::vector<MeshReport::Body> CompareBodies(const BodySurfaces& surfaces, const CartesianGrid& grid,
  const FractionField& fractions, const Mesh& mesh, Runtime& runtime)
{
  std::vector<SampledBody> bodies = SampleBodies(surfaces, runtime);
  for (std::size_t b = 0; b < bodies.size(); ++b)
  {
    FindPresent(surfaces.Bodies()[b].Material, grid, fractions, runtime, bodies[b]);
  }
  std::vector<SampleBins> all, lost;
  for (const SampledBody& body : bodies)
  {
    all.emplace_back(body.Samples, [](std::size_t) { return true; });
  }
  FindReached(surfaces, grid, mesh, all, NearReach, &SampledBody::IsNear, runtime, bodies);
  ShareFlags(&SampledBody::IsPresent, runtime.Group(), bodies);
  ShareFlags(&SampledBody::IsNear, runtime.Group(), bodies);
  for (const SampledBody& body : bodies)
  {
    lost.emplace_back(body.Samples, [&body](std::size_t s) { return body.IsLost(s); });
  }
  FindReached(surfaces, grid, mesh, lost, FarReach, &SampledBody::IsNotFar, runtime, bodies);
  ShareFlags(&SampledBody::IsNotFar, runtime.Group(), bodies);
  std::vector<MeshReport::Body> reports;
  for (std::size_t b = 0; b < bodies.size(); ++b)
  {
    reports.push_back(ReportBody(bodies[b], grid, runtime));
    reports.back().Material = surfaces.Bodies()[b].Material;
  }
  return reports;
}

} // namespace vfm
