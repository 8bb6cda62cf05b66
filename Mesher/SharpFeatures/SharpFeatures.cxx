#include "SharpFeatures/SharpFeatures.h"

#include "Base/Sorted.h"
#include "SharpFeatures/SharpPairs.h"

#include <tuple>

namespace vfm
{
namespace
{

/// Residual of a quadric near its point, from which planes are searched for among the crossings.
constexpr double StrongResidual = 0.03;
/// Residual over all cells around a point, from which the models of nearby points are tried.
constexpr double WeakResidual = 0.02;

/// The model of point From may be tried at point At.
struct Candidate
{
  FeatureSite At, From;
  bool operator<(const Candidate& other) const
  {
    return std::tie(this->At.Point, this->From.Point) < std::tie(other.At.Point, other.From.Point);
  }
};
using Candidates = std::vector<Candidate>; // ascending

SiteList SitesOf(const Candidates& candidates)
{
  SiteList sites;
  for (const Candidate& candidate : candidates)
  {
    sites.push_back(candidate.At);
  }
  SortUnique(sites);
  return sites;
}

using Result = std::optional<FittedFeature>;

/// Finds models in three phases; each reads the results of the phases before it.
struct Work
{
  const FeatureInput& Input;
  const Partition& Parts;
  Runtime& Run;
  const Interface& Source = Input.Source;
  const FeatureSites Sites{ Source, Parts };
  SharpPairs Pairs{ Sites };
  SiteList Strong{};
  FoundFeatures Found = FoundFeatures(Source.Points().size());
};

FeatureSearch SearchOf(const Work& work, const FeatureSite& site)
{
  return FeatureSearch(work.Input, site.Node, site.Point, work.Pairs.Contains(site));
}

void FindStrong(Work& work)
{
  const SiteList& sites = work.Sites.Near();
  std::vector<unsigned char> isStrong(sites.size(), 0);
  ForEach(work.Run, sites.size(),
    [&](Index i) { isStrong[i] = SearchOf(work, sites[i]).NearResidual() >= StrongResidual; });
  for (std::size_t i = 0; i < sites.size(); ++i)
  {
    if (isStrong[i])
    {
      work.Strong.push_back(sites[i]);
    }
  }
}

/// Calls search(site, walk) at each site. Results replace earlier models only after all
/// sites have been searched.
template <class Search>
void SearchAll(Work& work, const SiteList& sites, const Search& search)
{
  std::vector<Result> results(sites.size());
  work.Run.For(0, static_cast<Index>(sites.size()),
    [&](Index begin, Index end)
    {
      FaceWalk walk(work.Source);
      for (Index i = begin; i < end; ++i)
      {
        results[i] = search(sites[i], walk);
      }
    });
  for (std::size_t i = 0; i < sites.size(); ++i)
  {
    if (results[i])
    {
      work.Found[sites[i].Point] = std::make_unique<const FittedFeature>(*results[i]);
    }
  }
}

void SearchCrossingsAt(Work& work, const SiteList& sites)
{
  SearchAll(work, sites,
    [&](const FeatureSite& site, FaceWalk& walk)
    {
      FeatureSearch search = SearchOf(work, site);
      return search.Gather() ? search.FromCrossings(walk) : Result();
    });
}

void FindSharpPairs(Work& work)
{
  work.Pairs.Sample(work.Strong);
  SearchCrossingsAt(work, work.Pairs.Chosen());
  work.Pairs.Classify(work.Found);
}

void DropSmoothPairs(Work& work)
{
  const auto dropped = std::stable_partition(work.Strong.begin(), work.Strong.end(),
    [&](const FeatureSite& site) { return work.Pairs.Contains(site); });
  std::for_each(
    dropped, work.Strong.end(), [&](const FeatureSite& site) { work.Found[site.Point].reset(); });
  work.Strong.erase(dropped, work.Strong.end());
}

/// First phase: searches some of the strong points, including points near the owned ones.
void SearchCrossings(Work& work)
{
  SiteList sites;
  std::copy_if(work.Strong.begin(), work.Strong.end(), std::back_inserter(sites),
    [&](const FeatureSite& site) { return work.Sites.IsFirst(site) && !work.Found[site.Point]; });
  SearchCrossingsAt(work, sites);
}

/// Calls visit(site, feature) for each owned or nearby point that has a model, ascending.
template <class Visitor>
void ForFound(const Work& work, const Visitor& visit)
{
  for (const FeatureSite& site : work.Sites.Near())
  {
    if (work.Found[site.Point])
    {
      visit(site, *work.Found[site.Point]);
    }
  }
}

/// Lists the points at which the models found so far may be tried.
Candidates FindCandidates(const Work& work)
{
  Candidates candidates;
  ForFound(work,
    [&](const FeatureSite& from, const FittedFeature&)
    {
      for (const FeatureSite& at : work.Sites.ListAround(from))
      {
        candidates.push_back({ at, from });
      }
    });
  std::sort(candidates.begin(), candidates.end());
  return candidates;
}

bool IsStrong(const Work& work, const FeatureSite& site)
{
  return std::binary_search(work.Strong.begin(), work.Strong.end(), site);
}

/// Lists the models to try at a point, the nearest first.
std::vector<NearFeature> ListModels(
  const Work& work, const FeatureSite& site, const Candidates& candidates)
{
  const NodeFrame frame = FrameOf(work.Source, site.Node);
  const auto range = std::equal_range(candidates.begin(), candidates.end(), Candidate{ site, {} },
    [](const Candidate& a, const Candidate& b) { return a.At < b.At; });
  std::vector<NearFeature> models;
  for (auto candidate = range.first; candidate != range.second; ++candidate)
  {
    const Vector3 origin = FrameOf(work.Source, candidate->From.Node).Origin;
    models.push_back(
      { work.Found[candidate->From.Point].get(), Divided(origin - frame.Origin, frame.Widths) });
  }
  std::stable_sort(models.begin(), models.end(),
    [](const NearFeature& a, const NearFeature& b)
    { return Dot(a.From, a.From) < Dot(b.From, b.From); });
  return models;
}

Result SearchAt(
  const Work& work, const FeatureSite& site, const Candidates& candidates, FaceWalk& walk)
{
  const FittedFeature* own = work.Found[site.Point].get();
  FeatureSearch search = SearchOf(work, site);
  if ((own && own->Residual < ExcellentResidual) || !search.Gather() ||
    search.QuadricResidual() < WeakResidual)
  {
    return {};
  }
  const std::vector<NearFeature> models = ListModels(work, site, candidates);
  Result found = search.FromModels(models);
  if (own)
  {
    return found && found->Residual < own->Residual ? found : Result();
  }
  if (!found && !models.empty())
  {
    found = search.FromSurfaces(models);
  }
  if (!found && !work.Sites.IsFirst(site) && IsStrong(work, site))
  {
    found = search.FromCrossings(walk);
  }
  return found;
}

/// Second phase: searches the owned points, starting from the models of the first phase.
void SearchModels(Work& work)
{
  const Candidates candidates = FindCandidates(work);
  SiteList sites = SitesOf(candidates);
  const SiteList strong = work.Sites.ListOwned(work.Strong);
  sites.insert(sites.end(), strong.begin(), strong.end());
  SortUnique(sites);
  SearchAll(work, sites,
    [&](const FeatureSite& site, FaceWalk& walk)
    { return SearchAt(work, site, candidates, walk); });
}

/// Third phase: tries the models found so far at strong points that still lack one, for example
/// near corners and in gaps of edges. Only pairs that have edges are searched.
void SearchLeft(Work& work)
{
  const auto isDone = [&](const Candidate& candidate)
  {
    const FeatureSite& at = candidate.At;
    return work.Found[at.Point] || !IsStrong(work, at) || !work.Pairs.Contains(at);
  };
  Candidates candidates = FindCandidates(work);
  candidates.erase(std::remove_if(candidates.begin(), candidates.end(), isDone), candidates.end());
  SearchAll(work, SitesOf(candidates),
    [&](const FeatureSite& site, FaceWalk&)
    {
      FeatureSearch search = SearchOf(work, site);
      search.AcceptInGap();
      if (!search.Gather())
      {
        return Result();
      }
      const std::vector<NearFeature> models = ListModels(work, site, candidates);
      const Result found = search.FromModels(models);
      return found ? found : search.FromSurfaces(models);
    });
}

void FindAll(Work& work, SharpEdges mode)
{
  FindStrong(work);
  FindSharpPairs(work);
  if (mode == SharpEdges::Automatic)
  {
    DropSmoothPairs(work);
  }
  if (!work.Sites.Group().Any(!work.Strong.empty()))
  {
    return;
  }
  SearchCrossings(work);
  SearchModels(work);
  work.Sites.Share(work.Found);
  SearchLeft(work);
  work.Sites.Share(work.Found);
}

} // namespace

SharpFeatures::SharpFeatures(const Interface& interface, const FractionField& fractions,
  const SurfaceTargets& targets, Index firstTarget, SharpEdges mode, const Partition& partition,
  Runtime& runtime)
{
  if (mode == SharpEdges::Off)
  {
    return;
  }
  const FeatureInput input{ interface, fractions, targets, firstTarget };
  Work work{ input, partition, runtime };
  FindAll(work, mode);
  ForFound(work,
    [&](const FeatureSite& site, const FittedFeature& feature)
    {
      const NodeFrame frame = FrameOf(interface, site.Node);
      this->Points.push_back(site.Point);
      this->Models.push_back({ feature.Model, frame.Origin, frame.Widths });
    });
}

} // namespace vfm
