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

/// What the search at a site reads.
struct SiteSearch
{
  const FeatureInput& Input;
  const FeatureSites& Sites;
  const SharpPairs& Pairs;
  Runtime& Run;

  FeatureSearch At(const FeatureSite& site) const
  {
    return FeatureSearch(this->Input, site.Node, site.Point, this->Pairs.Contains(site));
  }
};

/// Returns the owned and nearby points where one surface does not explain the fractions.
SiteList FindStrong(const SiteSearch& search)
{
  const SiteList& sites = search.Sites.Near();
  std::vector<unsigned char> isStrong(sites.size(), 0);
  ForEach(search.Run, sites.size(),
    [&](Index i) { isStrong[i] = search.At(sites[i]).NearResidual() >= StrongResidual; });
  SiteList strong;
  for (std::size_t i = 0; i < sites.size(); ++i)
  {
    if (isStrong[i])
    {
      strong.push_back(sites[i]);
    }
  }
  return strong;
}

/// Calls searchAt(site, walk) at each site. Results replace earlier models only after all
/// sites have been searched.
template <class SearchAt>
void SearchAll(
  const SiteSearch& search, const SiteList& sites, const SearchAt& searchAt, FoundFeatures& found)
{
  std::vector<Result> results(sites.size());
  search.Run.For(0, static_cast<Index>(sites.size()),
    [&](Index begin, Index end)
    {
      FaceWalk walk(search.Input.Source);
      for (Index i = begin; i < end; ++i)
      {
        results[i] = searchAt(sites[i], walk);
      }
    });
  for (std::size_t i = 0; i < sites.size(); ++i)
  {
    if (results[i])
    {
      found[sites[i].Point] = std::make_unique<const FittedFeature>(*results[i]);
    }
  }
}

void SearchCrossingsAt(const SiteSearch& search, const SiteList& sites, FoundFeatures& found)
{
  const auto searchAt = [&](const FeatureSite& site, FaceWalk& walk)
  {
    FeatureSearch local = search.At(site);
    return local.Gather() ? local.FromCrossings(walk) : Result();
  };
  SearchAll(search, sites, searchAt, found);
}

/// Keeps only the strong points, and their models, of pairs with edges.
void DropSmoothPairs(const SharpPairs& pairs, SiteList& strong, FoundFeatures& found)
{
  const auto dropped = std::stable_partition(
    strong.begin(), strong.end(), [&](const FeatureSite& site) { return pairs.Contains(site); });
  std::for_each(dropped, strong.end(), [&](const FeatureSite& site) { found[site.Point].reset(); });
  strong.erase(dropped, strong.end());
}

/// First phase: searches some of the strong points, including points near the owned ones.
void SearchCrossings(const SiteSearch& search, const SiteList& strong, FoundFeatures& found)
{
  SiteList sites;
  std::copy_if(strong.begin(), strong.end(), std::back_inserter(sites),
    [&](const FeatureSite& site) { return search.Sites.IsFirst(site) && !found[site.Point]; });
  SearchCrossingsAt(search, sites, found);
}

/// Calls visit(site, feature) for each owned or nearby point that has a model, ascending.
template <class Visitor>
void ForFound(const FeatureSites& sites, const FoundFeatures& found, const Visitor& visit)
{
  for (const FeatureSite& site : sites.Near())
  {
    if (found[site.Point])
    {
      visit(site, *found[site.Point]);
    }
  }
}

/// Lists the points at which the models found so far may be tried.
Candidates FindCandidates(const FeatureSites& sites, const FoundFeatures& found)
{
  Candidates candidates;
  ForFound(sites, found,
    [&](const FeatureSite& from, const FittedFeature&)
    {
      for (const FeatureSite& at : sites.ListAround(from))
      {
        candidates.push_back({ at, from });
      }
    });
  std::sort(candidates.begin(), candidates.end());
  return candidates;
}

bool IsStrong(const SiteList& strong, const FeatureSite& site)
{
  return std::binary_search(strong.begin(), strong.end(), site);
}

/// Lists the models to try at a point, the nearest first.
std::vector<NearFeature> ListModels(const Interface& interface, const FoundFeatures& found,
  const Candidates& candidates, const FeatureSite& site)
{
  const NodeFrame frame = FrameOf(interface, site.Node);
  const auto range = std::equal_range(candidates.begin(), candidates.end(), Candidate{ site, {} },
    [](const Candidate& a, const Candidate& b) { return a.At < b.At; });
  std::vector<NearFeature> models;
  for (auto candidate = range.first; candidate != range.second; ++candidate)
  {
    const Vector3 origin = FrameOf(interface, candidate->From.Node).Origin;
    models.push_back(
      { found[candidate->From.Point].get(), Divided(origin - frame.Origin, frame.Widths) });
  }
  std::stable_sort(models.begin(), models.end(),
    [](const NearFeature& a, const NearFeature& b)
    { return Dot(a.From, a.From) < Dot(b.From, b.From); });
  return models;
}

/// Returns whether models are tried at a point.
/// @param own  its model, or nullptr
bool NeedsModel(FeatureSearch& local, const FittedFeature* own)
{
  const bool isExcellent = own && own->Residual < ExcellentResidual;
  return !isExcellent && local.Gather() && !(local.QuadricResidual() < WeakResidual);
}

/// Returns a model from those nearby.
/// @param own  model that it must be better than, or nullptr
Result SearchNearby(
  FeatureSearch& local, const std::vector<NearFeature>& models, const FittedFeature* own)
{
  const Result found = local.FromModels(models);
  if (own)
  {
    return found && found->Residual < own->Residual ? found : Result();
  }
  return found || models.empty() ? found : local.FromSurfaces(models);
}

/// Second phase: searches the owned points, starting from the models of the first phase.
void SearchModels(const SiteSearch& search, const SiteList& strong, FoundFeatures& found)
{
  const Candidates candidates = FindCandidates(search.Sites, found);
  SiteList sites = SitesOf(candidates);
  const SiteList owned = search.Sites.ListOwned(strong);
  sites.insert(sites.end(), owned.begin(), owned.end());
  SortUnique(sites);
  const auto searchAt = [&](const FeatureSite& site, FaceWalk& walk)
  {
    const FittedFeature* own = found[site.Point].get();
    FeatureSearch local = search.At(site);
    if (!NeedsModel(local, own))
    {
      return Result();
    }
    const Result nearby =
      SearchNearby(local, ListModels(search.Input.Source, found, candidates, site), own);
    const bool isLast = own || nearby || search.Sites.IsFirst(site) || !IsStrong(strong, site);
    return isLast ? nearby : local.FromCrossings(walk);
  };
  SearchAll(search, sites, searchAt, found);
}

/// Third phase: tries the models found so far at strong points that still lack one, for example
/// near corners and in gaps of edges. Only pairs that have edges are searched.
void SearchLeft(const SiteSearch& search, const SiteList& strong, FoundFeatures& found)
{
  const auto isDone = [&](const Candidate& candidate)
  {
    const FeatureSite& at = candidate.At;
    return found[at.Point] || !IsStrong(strong, at) || !search.Pairs.Contains(at);
  };
  Candidates candidates = FindCandidates(search.Sites, found);
  candidates.erase(std::remove_if(candidates.begin(), candidates.end(), isDone), candidates.end());
  const auto searchAt = [&](const FeatureSite& site, FaceWalk&)
  {
    FeatureSearch local = search.At(site);
    local.AcceptInGap();
    if (!local.Gather())
    {
      return Result();
    }
    const std::vector<NearFeature> models =
      ListModels(search.Input.Source, found, candidates, site);
    const Result nearby = local.FromModels(models);
    return nearby ? nearby : local.FromSurfaces(models);
  };
  SearchAll(search, SitesOf(candidates), searchAt, found);
}

/// Finds models in three phases; each reads the results of the phases before it.
FoundFeatures FindModels(
  const FeatureInput& input, const FeatureSites& sites, SharpEdgeMode mode, Runtime& runtime)
{
  FoundFeatures found(input.Source.Points().size());
  SharpPairs pairs(sites);
  const SiteSearch search{ input, sites, pairs, runtime };
  SiteList strong = FindStrong(search);
  pairs.Sample(strong);
  SearchCrossingsAt(search, pairs.Chosen(), found);
  pairs.Classify(found);
  if (mode == SharpEdgeMode::Automatic)
  {
    DropSmoothPairs(pairs, strong, found);
  }
  if (!sites.Group().Any(!strong.empty()))
  {
    return found;
  }
  SearchCrossings(search, strong, found);
  SearchModels(search, strong, found);
  sites.Share(found);
  SearchLeft(search, strong, found);
  sites.Share(found);
  return found;
}

} // namespace

SharpFeatures::SharpFeatures(const Interface& interface, const FractionField& fractions,
  const SurfaceTargets& targets, Index firstTarget, const PairFilter& isSought, SharpEdgeMode mode,
  const Partition& partition, Runtime& runtime)
{
  if (mode == SharpEdgeMode::Off)
  {
    return;
  }
  const FeatureInput input{ interface, fractions, targets, firstTarget };
  const FeatureSites sites(interface, partition, isSought);
  ForFound(sites, FindModels(input, sites, mode, runtime),
    [&](const FeatureSite& site, const FittedFeature& feature)
    {
      const NodeFrame frame = FrameOf(interface, site.Node);
      this->Targets.push_back(firstTarget + site.Point);
      this->Models.push_back({ feature.Model, frame.Origin, frame.Widths });
    });
}

void SharpFeatures::Add(const SharpFeatures& other)
{
  std::vector<std::pair<Index, NodeFeature>> all;
  for (const SharpFeatures* each : { static_cast<const SharpFeatures*>(this), &other })
  {
    for (std::size_t i = 0; i < each->Targets.size(); ++i)
    {
      all.emplace_back(each->Targets[i], each->Models[i]);
    }
  }
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  *this = SharpFeatures();
  for (const auto& [target, model] : all)
  {
    this->Targets.push_back(target);
    this->Models.push_back(model);
  }
}

} // namespace vfm
