#include "Creases/Creases.h"

#include "Base/Sorted.h"
#include "Creases/SharpPairs.h"

#include <tuple>

namespace vfm
{
namespace
{

/// Residual of the quadric near a point, at which crossings are searched.
constexpr double StrongResidual = 0.03;
/// Over all cells around, at which models of points near are tried.
constexpr double WeakResidual = 0.02;

/// That the model of another point may be tried at one.
struct Candidate
{
  CreaseSite At, From;
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

/// Finds models in three phases; each reads what those before have found.
class CreaseFinder
{
public:
  CreaseFinder(const CreaseInput& input, const Partition& partition, Runtime& runtime) :
    Input(input),
    Source(input.Source),
    Sites(input.Source, partition),
    Pairs(Sites),
    Run(runtime),
    Found(Source.Points().size())
  {
  }

  void Find(SharpEdges mode)
  {
    this->FindStrong();
    this->FindSharpPairs();
    if (mode == SharpEdges::Automatic)
    {
      this->DropSmoothPairs();
    }
    if (!this->Sites.Group().Any(!this->Strong.empty()))
    {
      return;
    }
    this->SearchCrossings();
    this->SearchModels();
    this->Sites.Share(this->Found);
    this->SearchLeft();
    this->Sites.Share(this->Found);
  }

  /// Calls visit(site, crease) for the owned points that have one and those near, ascending.
  template <class Visitor>
  void ForFound(const Visitor& visit) const
  {
    for (const CreaseSite& site : this->Sites.Near())
    {
      if (this->Found[site.Point])
      {
        visit(site, *this->Found[site.Point]);
      }
    }
  }

private:
  using Result = std::optional<FittedCrease>;

  CreaseSearch SearchOf(const CreaseSite& site) const
  {
    return CreaseSearch(this->Input, site.Node, site.Point, this->Pairs.Contains(site));
  }
  bool IsStrong(const CreaseSite& site) const
  {
    return std::binary_search(this->Strong.begin(), this->Strong.end(), site);
  }

  void FindStrong()
  {
    const SiteList& sites = this->Sites.Near();
    std::vector<unsigned char> isStrong(sites.size(), 0);
    ForEach(this->Run, sites.size(),
      [&](Index i) { isStrong[i] = this->SearchOf(sites[i]).NearResidual() >= StrongResidual; });
    for (std::size_t i = 0; i < sites.size(); ++i)
    {
      if (isStrong[i])
      {
        this->Strong.push_back(sites[i]);
      }
    }
  }

  void FindSharpPairs()
  {
    this->Pairs.Sample(this->Strong);
    this->SearchCrossingsAt(this->Pairs.Chosen());
    this->Pairs.Judge(this->Found);
  }

  void DropSmoothPairs()
  {
    const auto dropped = std::stable_partition(this->Strong.begin(), this->Strong.end(),
      [this](const CreaseSite& site) { return this->Pairs.Contains(site); });
    std::for_each(dropped, this->Strong.end(),
      [this](const CreaseSite& site) { this->Found[site.Point].reset(); });
    this->Strong.erase(dropped, this->Strong.end());
  }

  /// search(site, walk): what is found at a site; kept after all have been searched, in place of what was found there before.
  template <class Search>
  void SearchAll(const SiteList& sites, const Search& search)
  {
    std::vector<Result> results(sites.size());
    this->Run.For(0, static_cast<Index>(sites.size()),
      [&](Index begin, Index end)
      {
        FaceWalk walk(this->Source);
        for (Index i = begin; i < end; ++i)
        {
          results[i] = search(sites[i], walk);
        }
      });
    for (std::size_t i = 0; i < sites.size(); ++i)
    {
      if (results[i])
      {
        this->Found[sites[i].Point] = std::make_unique<const FittedCrease>(*results[i]);
      }
    }
  }

  void SearchCrossingsAt(const SiteList& sites)
  {
    this->SearchAll(sites,
      [this](const CreaseSite& site, FaceWalk& walk)
      {
        CreaseSearch search = this->SearchOf(site);
        return search.Gather() ? search.FromCrossings(walk) : Result();
      });
  }

  /// First phase: some of the strong points, also beside the owned ones.
  void SearchCrossings()
  {
    SiteList sites;
    std::copy_if(this->Strong.begin(), this->Strong.end(), std::back_inserter(sites),
      [this](const CreaseSite& site)
      { return this->Sites.IsFirst(site) && !this->Found[site.Point]; });
    this->SearchCrossingsAt(sites);
  }

  /// Where the models that have been found by now may be tried.
  Candidates FindCandidates() const
  {
    Candidates candidates;
    this->ForFound(
      [&](const CreaseSite& from, const FittedCrease&)
      {
        for (const CreaseSite& at : this->Sites.ListAround(from))
        {
          candidates.push_back({ at, from });
        }
      });
    std::sort(candidates.begin(), candidates.end());
    return candidates;
  }

  /// The models to be tried at a point, the nearest first.
  std::vector<NearCrease> ListModels(const CreaseSite& site, const Candidates& candidates) const
  {
    const NodeFrame frame = FrameOf(this->Source, site.Node);
    const auto range = std::equal_range(candidates.begin(), candidates.end(), Candidate{ site, {} },
      [](const Candidate& a, const Candidate& b) { return a.At < b.At; });
    std::vector<NearCrease> models;
    for (auto candidate = range.first; candidate != range.second; ++candidate)
    {
      const Vector3 origin = FrameOf(this->Source, candidate->From.Node).Origin;
      models.push_back(
        { this->Found[candidate->From.Point].get(), Divided(origin - frame.Origin, frame.Widths) });
    }
    std::stable_sort(models.begin(), models.end(),
      [](const NearCrease& a, const NearCrease& b)
      { return Dot(a.From, a.From) < Dot(b.From, b.From); });
    return models;
  }

  /// Second phase: all owned points, from the models of the first.
  void SearchModels()
  {
    const Candidates candidates = this->FindCandidates();
    SiteList sites = SitesOf(candidates);
    const SiteList strong = this->Sites.ListOwned(this->Strong);
    sites.insert(sites.end(), strong.begin(), strong.end());
    SortUnique(sites);
    this->SearchAll(sites,
      [&](const CreaseSite& site, FaceWalk& walk)
      { return this->SearchAt(site, candidates, walk); });
  }

  Result SearchAt(const CreaseSite& site, const Candidates& candidates, FaceWalk& walk) const
  {
    const FittedCrease* own = this->Found[site.Point].get();
    CreaseSearch search = this->SearchOf(site);
    if ((own && own->Residual < ExcellentResidual) || !search.Gather() ||
      search.QuadricResidual() < WeakResidual)
    {
      return {};
    }
    const std::vector<NearCrease> models = this->ListModels(site, candidates);
    Result found = search.FromModels(models);
    if (own)
    {
      return found && found->Residual < own->Residual ? found : Result();
    }
    if (!found && !models.empty())
    {
      found = search.FromSurfaces(models);
    }
    if (!found && !this->Sites.IsFirst(site) && this->IsStrong(site))
    {
      found = search.FromCrossings(walk);
    }
    return found;
  }

  /// Third phase: strong points of pairs that have edges, still without a model as near corners, from what those around have found by now.
  void SearchLeft()
  {
    const auto isDone = [this](const Candidate& candidate)
    {
      const CreaseSite& at = candidate.At;
      return this->Found[at.Point] || !this->IsStrong(at) || !this->Pairs.Contains(at);
    };
    Candidates candidates = this->FindCandidates();
    candidates.erase(
      std::remove_if(candidates.begin(), candidates.end(), isDone), candidates.end());
    this->SearchAll(SitesOf(candidates),
      [&](const CreaseSite& site, FaceWalk&)
      {
        CreaseSearch search = this->SearchOf(site);
        if (!search.Gather())
        {
          return Result();
        }
        const std::vector<NearCrease> models = this->ListModels(site, candidates);
        const Result found = search.FromModels(models);
        return found ? found : search.FromSurfaces(models);
      });
  }

  const CreaseInput& Input;
  const Interface& Source;
  const CreaseSites Sites;
  SharpPairs Pairs;
  Runtime& Run;
  SiteList Strong;
  FoundCreases Found;
};

} // namespace

Creases::Creases(const Interface& interface, const FractionField& fractions,
  const SurfaceTargets& targets, Index firstTarget, SharpEdges mode, const Partition& partition,
  Runtime& runtime)
{
  if (mode == SharpEdges::Off)
  {
    return;
  }
  const CreaseInput input{ interface, fractions, targets, firstTarget };
  CreaseFinder finder(input, partition, runtime);
  finder.Find(mode);
  finder.ForFound(
    [&](const CreaseSite& site, const FittedCrease& crease)
    {
      const NodeFrame frame = FrameOf(interface, site.Node);
      this->Points.push_back(site.Point);
      this->Models.push_back({ crease.Model, frame.Origin, frame.Widths });
    });
}

} // namespace vfm
