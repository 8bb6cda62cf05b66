#include "Volumes/FacetSums.h"

#include "Volumes/FacetSweeps.h"

#include <cstring>
#include <mutex>

namespace vfm
{
namespace
{

constexpr Index LongestRun = 64; // facets

void Prefetch(const ActiveMesh& mesh, const ActiveFacet& facet)
{
  for (int point : facet.Points)
  {
    __builtin_prefetch(&mesh.X[point]);
    mesh.PrefetchStart(point);
  }
}

/// Collects the corners of some facets; the last one is repeated until all fours are complete.
/// Begins to load what is read of the facets that follow.
/// @param end  end of the facets that follow
void CollectCorners(
  const ActiveMesh& mesh, Index first, Index last, Index end, FacetCorners& corners)
{
  for (int n = 0; first + n < last || n % 4 != 0; ++n)
  {
    const Index f = std::min(first + n, last - 1);
    if (f + FacetCorners::Most < end)
    {
      Prefetch(mesh, mesh.Facets[f + FacetCorners::Most]);
    }
    for (int c = 0; c < 4; ++c)
    {
      const int point = mesh.Facets[f].Points[c];
      corners.Set(n, c, mesh.StartOf(point), mesh.X[point]);
    }
  }
}

} // namespace

void FacetSums::Start(const ActiveMesh& mesh, std::size_t fragments, Runtime& runtime)
{
  this->TheSwept.assign(fragments, {});
  this->TheAreas.clear();
  this->FindRuns(mesh);
  this->Update(mesh, Flags(mesh.X.size(), 1), runtime);
}

void FacetSums::FindRuns(const ActiveMesh& mesh)
{
  this->Runs.clear();
  const Index facets = static_cast<Index>(mesh.Facets.size());
  for (Index f = 0; f < facets; ++f)
  {
    const ActiveFacet& facet = mesh.Facets[f];
    const auto [low, high] = std::minmax_element(facet.Points.begin(), facet.Points.end());
    if (f == 0 || this->Runs.back().Fragments != facet.Fragments ||
      f - this->Runs.back().First == LongestRun)
    {
      this->Runs.push_back({ f, f, facet.Fragments, { { *low, *high } }, {}, {} });
    }
    FacetRun& run = this->Runs.back();
    run.End = f + 1;
    run.Points = { { std::min(run.Points[0], *low), std::max(run.Points[1], *high) } };
  }
}

void FacetSums::Update(const ActiveMesh& mesh, const Flags& moved, Runtime& runtime)
{
  std::mutex lock;
  runtime.For(0, static_cast<Index>(this->Runs.size()),
    [&](Index begin, Index end)
    {
      std::vector<std::pair<Index, FacetRun>> old;
      for (Index r = begin; r < end; ++r)
      {
        if (HasMoved(mesh, this->Runs[r], moved))
        {
          old.emplace_back(r, this->Runs[r]);
          Sum(mesh, this->Runs[r]);
        }
      }
      const std::lock_guard<std::mutex> guard(lock);
      for (const auto& [r, run] : old)
      {
        this->Replace(run, this->Runs[r]);
      }
    });
}

bool FacetSums::HasMoved(const ActiveMesh& mesh, const FacetRun& run, const Flags& moved)
{
  const Index points = run.Points[1] + 1 - run.Points[0];
  return std::memchr(moved.data() + run.Points[0], 1, points) && // faster than std::find
    std::any_of(mesh.Facets.begin() + run.First, mesh.Facets.begin() + run.End,
      [&](const ActiveFacet& facet)
      {
        const std::array<int, 4>& p = facet.Points;
        return (moved[p[0]] | moved[p[1]] | moved[p[2]] | moved[p[3]]) != 0;
      });
}

void FacetSums::Sum(const ActiveMesh& mesh, FacetRun& run)
{
  run.Swept = run.Area = ExactSum();
  FacetCorners corners;
  double volumes[FacetCorners::Most], areas[FacetCorners::Most];
  for (Index first = run.First; first < run.End; first += FacetCorners::Most)
  {
    const Index last = std::min(run.End, first + FacetCorners::Most);
    const int facets = static_cast<int>(last - first);
    CollectCorners(mesh, first, last, run.End, corners);
    corners.Measure(facets, volumes, areas);
    for (int f = 0; f < facets; ++f)
    {
      run.Swept.Add(volumes[f]);
      run.Area.Add(areas[f]);
    }
  }
}

/// Replaces the sums of a run in the totals.
void FacetSums::Replace(const FacetRun& from, const FacetRun& to)
{
  const auto& [behind, before] = to.Fragments;
  ExactSum swept = to.Swept, area = to.Area;
  swept.Subtract(from.Swept);
  area.Subtract(from.Area);
  this->TheSwept[behind].Add(swept);
  this->TheSwept[before].Subtract(swept);
  this->TheAreas[std::minmax(behind, before)].Add(area);
}

} // namespace vfm
