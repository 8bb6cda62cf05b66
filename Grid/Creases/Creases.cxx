#include "Creases/Creases.h"

#include "Base/PairSums.h"
#include "Base/Sorted.h"
#include "Creases/CreaseSearch.h"

#include <memory>
#include <set>
#include <tuple>

namespace vfm
{
namespace
{

constexpr double StrongResidual =
  0.03; // of the quadric near a point, at which crossings are searched
constexpr double WeakResidual =
  0.02;                       // over all cells around, at which models of nodes near are tried
constexpr Index Spread = 2;   // nodes along each axis that a model is tried at
constexpr Index Thinning = 3; // of the diagonals of nodes that are searched first
constexpr double SampleSize = 128.0; // points that tell whether a pair has edges
constexpr double SampleShare = 0.4;  // of them that must have models

using Fits = std::vector<std::unique_ptr<const FittedCrease>>; // by surface point
using LabelPair = std::pair<int, int>;

/// A surface point and its node, as positions in the interface.
struct Place
{
  Index Node, Point;
  bool operator<(const Place& other) const { return this->Point < other.Point; }
  bool operator==(const Place& other) const { return this->Point == other.Point; }
};

/// That the model of another point may be tried at one.
struct Candidate
{
  Place At, From;
  bool operator<(const Candidate& other) const
  {
    return std::tie(this->At.Point, this->From.Point) < std::tie(other.At.Point, other.From.Point);
  }
};

class CreaseFinder
{
public:
  CreaseFinder(const CreaseInput& input, const Partition& partition, Runtime& runtime) :
    Input(input),
    Source(input.Source),
    Parts(partition),
    Run(runtime),
    First(Source.Points().size()),
    Second(Source.Points().size()),
    Third(Source.Points().size())
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
    this->SearchFirst(this->Strong, [this](const Place& place) { return this->IsFirst(place); });
    this->SearchSecond();
    this->Share();
    this->SearchThird();
    this->Share();
  }

  /// Calls visit(place, crease) for the points with one, ascending: those at owned nodes and near these.
  template <class Visitor>
  void ForNear(const Visitor& visit) const
  {
    this->ForPlaces(
      [&](const Place& place)
      {
        const FittedCrease* crease = this->IsNear(place.Node) ? this->Find(place.Point) : nullptr;
        if (crease)
        {
          visit(place, *crease);
        }
      });
  }

private:
  /// What has been found last.
  const FittedCrease* Find(Index point) const
  {
    return this->Third[point] ? this->Third[point].get() : this->FindEarly(point);
  }
  const FittedCrease* FindEarly(Index point) const
  {
    return (this->Second[point] ? this->Second : this->First)[point].get();
  }
  template <class Visitor>
  void ForPlaces(const Visitor& visit) const
  {
    for (Index n = 0; n < static_cast<Index>(this->Source.Nodes().size()); ++n)
    {
      for (Index p = this->Source.PointOffset(n); p < this->Source.PointOffset(n + 1); ++p)
      {
        visit(Place{ n, p });
      }
    }
  }
  Index3 PositionOf(Index node) const
  {
    return this->Source.Grid().Position(this->Source.Nodes()[node]);
  }
  bool IsOwned(Index node) const { return this->Parts.OwnsNode(this->PositionOf(node)); }
  /// Whether a model at the node may be tried at owned nodes.
  bool IsNear(Index node) const
  {
    const CartesianGrid& grid = this->Source.Grid();
    return NodesOf(Grow(grid.Owned(), Spread, grid.Global())).Contains(this->PositionOf(node));
  }
  bool IsFirst(const Place& place) const
  {
    const Index3 p = this->PositionOf(place.Node);
    return (p[0] + p[1] + p[2]) % Thinning == 0;
  }
  LabelPair PairOf(Index point) const
  {
    const SurfacePoint& at = this->Source.Points()[point];
    return { at.First, at.Second };
  }

  /// Of the points that this rank owns and of those whose models are tried there.
  void FindStrong()
  {
    std::vector<Place> places;
    this->ForPlaces(
      [&](const Place& place)
      {
        if (this->IsNear(place.Node))
        {
          places.push_back(place);
        }
      });
    std::vector<unsigned char> isStrong(places.size(), 0);
    ForEach(this->Run, places.size(),
      [&](Index i) { isStrong[i] = this->SearchOf(places[i]).NearResidual() >= StrongResidual; });
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      if (isStrong[i])
      {
        this->Strong.push_back(places[i]);
      }
    }
  }

  /// Sums over pairs of labels of all ranks of what count(place) gives for the owned strong points.
  template <class Count>
  std::vector<PairSum> SumByPair(const Count& count) const
  {
    PairSumMap sums;
    for (const Place& place : this->Strong)
    {
      if (this->IsOwned(place.Node))
      {
        sums[this->PairOf(place.Point)].Add(count(place));
      }
    }
    return GatherPairSums(sums, this->Parts.Group());
  }

  /// Pairs where enough of a sample of their strong points has models: there the fractions tell of edges nearly everywhere.
  void FindSharpPairs()
  {
    std::map<LabelPair, Index> stride;
    for (const PairSum& sum :
      this->SumByPair([this](const Place& place) { return this->IsFirst(place) ? 1.0 : 0.0; }))
    {
      stride[{ sum.First, sum.Second }] =
        std::max<Index>(1, static_cast<Index>(std::ceil(sum.Value.Value() / SampleSize)));
    }
    const auto isSample = [&](const Place& place)
    {
      return this->IsFirst(place) &&
        this->Shuffled(place.Node) % stride.at(this->PairOf(place.Point)) == 0;
    };
    std::vector<Place> mine;
    std::copy_if(this->Strong.begin(), this->Strong.end(), std::back_inserter(mine),
      [&](const Place& place) { return this->IsOwned(place.Node); });
    this->SearchFirst(mine, isSample);
    const auto balance = [&](const Place& place)
    { return !isSample(place) ? 0.0 : (this->First[place.Point] ? 1.0 : 0.0) - SampleShare; };
    for (const PairSum& sum : this->SumByPair(balance))
    {
      if (sum.Value.Value() > 0.0)
      {
        this->SharpPairs.insert({ sum.First, sum.Second });
      }
    }
  }
  bool IsSharp(const Place& place) const
  {
    return this->SharpPairs.count(this->PairOf(place.Point)) > 0;
  }

  CreaseSearch SearchOf(const Place& place) const
  {
    return CreaseSearch(this->Input, place.Node, place.Point, this->IsSharp(place));
  }

  void DropSmoothPairs()
  {
    const auto dropped = std::stable_partition(this->Strong.begin(), this->Strong.end(),
      [this](const Place& place) { return this->IsSharp(place); });
    std::for_each(dropped, this->Strong.end(),
      [this](const Place& place) { this->First[place.Point].reset(); });
    this->Strong.erase(dropped, this->Strong.end());
  }

  /// A number of a node, the same on all ranks, that tells nothing of where it is.
  Index Shuffled(Index node) const
  {
    const std::uint64_t key =
      static_cast<std::uint64_t>(this->Source.Grid().NodeKey(this->PositionOf(node)));
    return static_cast<Index>((key * 0x9E3779B97F4A7C15u) >> 32);
  }

  template <class Predicate>
  void SearchFirst(const std::vector<Place>& places, const Predicate& isWanted)
  {
    std::vector<Place> wanted;
    std::copy_if(places.begin(), places.end(), std::back_inserter(wanted),
      [&](const Place& place) { return !this->First[place.Point] && isWanted(place); });
    this->Run.For(0, static_cast<Index>(wanted.size()),
      [&](Index begin, Index end)
      {
        FaceWalk walk(this->Source);
        for (Index i = begin; i < end; ++i)
        {
          CreaseSearch search = this->SearchOf(wanted[i]);
          if (search.Gather())
          {
            this->Keep(search.FromCrossings(walk), this->First[wanted[i].Point]);
          }
        }
      });
  }

  static void Keep(
    const std::optional<FittedCrease>& found, std::unique_ptr<const FittedCrease>& kept)
  {
    if (found)
    {
      kept = std::make_unique<const FittedCrease>(*found);
    }
  }

  /// Which points of the same pair at owned nodes near some that have a model may try it.
  std::vector<Candidate> FindCandidates(const std::vector<Place>& places) const
  {
    std::vector<Candidate> candidates;
    const CartesianGrid& grid = this->Source.Grid();
    const IndexBox local = NodesOf(grid.Local());
    for (const Place& place : places)
    {
      const LabelPair pair = this->PairOf(place.Point);
      IndexBox box;
      const Index3 p = this->PositionOf(place.Node);
      for (int a = 0; a < 3; ++a)
      {
        box.Lower[a] = p[a] - Spread;
        box.Upper[a] = p[a] + Spread + 1;
      }
      this->ForNodes(Intersect(box, local),
        [&](Index node)
        {
          const SurfacePoint* point =
            this->IsOwned(node) ? this->Source.FindPoint(node, pair.first, pair.second) : nullptr;
          if (point)
          {
            const Index at = point - this->Source.Points().data();
            candidates.push_back({ { node, at }, place });
          }
        });
    }
    std::sort(candidates.begin(), candidates.end());
    return candidates;
  }

  /// Calls visit(position in Interface::Nodes()) for those in a box.
  template <class Visitor>
  void ForNodes(const IndexBox& box, const Visitor& visit) const
  {
    const std::vector<Index>& nodes = this->Source.Nodes();
    ForRows(box,
      [&](Index j, Index k)
      {
        const Index first = this->Source.Grid().Linear({ { box.Lower[0], j, k } });
        auto at = std::lower_bound(nodes.begin(), nodes.end(), first);
        for (; at != nodes.end() && *at < first + box.Size(0); ++at)
        {
          visit(at - nodes.begin());
        }
      });
  }

  void SearchSecond()
  {
    std::vector<Place> places;
    std::copy_if(this->Strong.begin(), this->Strong.end(), std::back_inserter(places),
      [this](const Place& place) { return this->First[place.Point] != nullptr; });
    const std::vector<Candidate> candidates = this->FindCandidates(places);
    places.clear();
    for (const Candidate& candidate : candidates)
    {
      places.push_back(candidate.At);
    }
    std::copy_if(this->Strong.begin(), this->Strong.end(), std::back_inserter(places),
      [&](const Place& place) { return this->IsOwned(place.Node); });
    SortUnique(places);
    this->Run.For(0, static_cast<Index>(places.size()),
      [&](Index begin, Index end)
      {
        FaceWalk walk(this->Source);
        for (Index i = begin; i < end; ++i)
        {
          this->SearchAt(places[i], CandidatesAt(places[i], candidates), walk);
        }
      });
  }

  /// Strong points that are still without a model, as near corners, try what those around have found by now.
  void SearchThird()
  {
    std::vector<Place> places;
    this->ForNear([&](const Place& place, const FittedCrease&) { places.push_back(place); });
    std::vector<Candidate> candidates = this->FindCandidates(places);
    const auto isInVain = [this](const Candidate& candidate)
    {
      return this->FindEarly(candidate.At.Point) ||
        !std::binary_search(this->Strong.begin(), this->Strong.end(), candidate.At);
    };
    candidates.erase(
      std::remove_if(candidates.begin(), candidates.end(), isInVain), candidates.end());
    places.clear();
    for (const Candidate& candidate : candidates)
    {
      places.push_back(candidate.At);
    }
    SortUnique(places);
    ForEach(this->Run, places.size(),
      [&](Index i)
      {
        CreaseSearch search = this->SearchOf(places[i]);
        if (search.Gather())
        {
          const std::vector<NearCrease> others =
            this->ListNear(places[i], CandidatesAt(places[i], candidates),
              [this](Index point) { return this->FindEarly(point); });
          const std::optional<FittedCrease> found = search.FromModels(others);
          Keep(found ? found : search.FromSurfaces(others), this->Third[places[i].Point]);
        }
      });
  }

  /// Gives the points of other ranks near the owned ones what these have found there. Collective among peers.
  void Share()
  {
    struct Answer
    {
      Index Asked; // how many were asked for before
      FittedCrease Found;
    };
    const std::vector<int>& peers = this->Parts.Peers();
    std::vector<std::vector<Place>> asked(peers.size());
    std::vector<std::vector<Index>> wanted(peers.size());
    this->ForPlaces(
      [&](const Place& place)
      {
        if (!this->IsOwned(place.Node) && this->IsNear(place.Node))
        {
          const Index3 at = this->PositionOf(place.Node);
          const LabelPair pair = this->PairOf(place.Point);
          const int peer = this->Parts.PeerOfNode(at);
          asked[peer].push_back(place);
          wanted[peer].insert(
            wanted[peer].end(), { this->Source.Grid().NodeKey(at), pair.first, pair.second });
          this->First[place.Point].reset();
          this->Second[place.Point].reset();
        }
      });
    std::vector<Bytes> messages;
    for (const std::vector<Index>& keys : this->Parts.Request(wanted))
    {
      std::vector<Answer> answers;
      for (std::size_t i = 0; i < keys.size(); i += 3)
      {
        const FittedCrease* found = this->FindByKey(keys.data() + i);
        if (found)
        {
          answers.push_back({ static_cast<Index>(i / 3), *found });
        }
      }
      messages.push_back(ToBytes(answers));
    }
    messages = this->Parts.Group().Exchange(peers, messages);
    for (std::size_t peer = 0; peer < peers.size(); ++peer)
    {
      for (const Answer& answer : FromBytes<Answer>(messages[peer]))
      {
        Keep(answer.Found, this->Second[asked[peer][answer.Asked].Point]);
      }
    }
  }

  /// key: of a node, and two labels.
  const FittedCrease* FindByKey(const Index* key) const
  {
    const CartesianGrid& grid = this->Source.Grid();
    const Index node = this->Source.Find(grid.Linear(grid.NodeOfKey(key[0])));
    const SurfacePoint* point = node < 0
      ? nullptr
      : this->Source.FindPoint(node, static_cast<int>(key[1]), static_cast<int>(key[2]));
    return point ? this->Find(point - this->Source.Points().data()) : nullptr;
  }

  using Candidates =
    std::pair<std::vector<Candidate>::const_iterator, std::vector<Candidate>::const_iterator>;

  static Candidates CandidatesAt(const Place& place, const std::vector<Candidate>& candidates)
  {
    return std::equal_range(candidates.begin(), candidates.end(), Candidate{ place, {} },
      [](const Candidate& a, const Candidate& b) { return a.At < b.At; });
  }

  void SearchAt(const Place& place, const Candidates& candidates, FaceWalk& walk)
  {
    const auto& own = this->First[place.Point];
    CreaseSearch search = this->SearchOf(place);
    if ((own && own->Residual < ExcellentResidual) || !search.Gather() ||
      search.QuadricResidual() < WeakResidual)
    {
      return;
    }
    const std::vector<NearCrease> others =
      this->ListNear(place, candidates, [this](Index point) { return this->First[point].get(); });
    std::optional<FittedCrease> found = search.FromModels(others);
    if (own)
    {
      if (found && found->Residual < own->Residual)
      {
        Keep(found, this->Second[place.Point]);
      }
      return;
    }
    if (!found && !others.empty())
    {
      found = search.FromSurfaces(others);
    }
    if (!found && !this->IsFirst(place) &&
      std::binary_search(this->Strong.begin(), this->Strong.end(), place))
    {
      found = search.FromCrossings(walk);
    }
    Keep(found, this->Second[place.Point]);
  }

  /// The models to be tried at a point, the nearest first. find(point): the model of another.
  template <class Find>
  std::vector<NearCrease> ListNear(
    const Place& place, const Candidates& candidates, const Find& find) const
  {
    const NodeFrame frame = FrameOf(this->Source, place.Node);
    std::vector<NearCrease> others;
    std::for_each(candidates.first, candidates.second,
      [&](const Candidate& candidate)
      {
        const Vector3 origin = FrameOf(this->Source, candidate.From.Node).Origin;
        others.push_back(
          { find(candidate.From.Point), Divided(origin - frame.Origin, frame.Widths) });
      });
    std::stable_sort(others.begin(), others.end(),
      [](const NearCrease& a, const NearCrease& b)
      { return Dot(a.From, a.From) < Dot(b.From, b.From); });
    return others;
  }

  const CreaseInput& Input;
  const Interface& Source;
  const Partition& Parts;
  Runtime& Run;
  std::vector<Place> Strong; // ascending
  std::set<LabelPair> SharpPairs;
  Fits First, Second, Third;
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
  finder.ForNear(
    [&](const Place& place, const FittedCrease& crease)
    {
      const NodeFrame frame = FrameOf(interface, place.Node);
      this->Points.push_back(place.Point);
      this->Models.push_back({ crease.Model, frame.Origin, frame.Widths });
    });
}

} // namespace vfm
