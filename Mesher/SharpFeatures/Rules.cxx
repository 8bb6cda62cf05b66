#include "SharpFeatures/Rules.h"

#include <limits>

namespace vfm
{
namespace
{

constexpr double LargestCosine = 0.883; // cosine of 28 degrees, between the normals of two sides
// Largest distance of a point to the edge that Cover makes it carry, in cells.
constexpr double CoverReach = 1.6;
// The first round finds no edge carriers. Hexes deteriorate where carriers crowd, so they
// get only one round.
constexpr int HexCoverRounds = 1, TetCoverRounds = 3;
// The same for zigzags, where only the shape of the chain matters.
constexpr double ZigzagReach = 1.2;
constexpr double CornerReach = 2.0;
// Below this distance, in mean cells, two models have the same corner.
constexpr double SameCorner = 1.0;
constexpr int CornerRings = 3;           // rings of facets
constexpr std::size_t ShortestChain = 9; // carriers
// Largest difference of the chords of an edge at two adjacent carriers.
constexpr double LargestTurn = 0.2;
constexpr int ChainRings = 8, SideRings = 3;
constexpr int MaximumPairs = 3; // pairs of labels, at one point, that ranks exchange
constexpr Index NoId = std::numeric_limits<Index>::max();

// Chords of points that carry nothing, and of corners.
constexpr double NoChord = -1.0, AnyChord = 10.0;

/// Part of an edge, as known at one of its carriers: the lowest ids of connected
/// carriers, ascending, and the chord between the unit normals of the two surfaces, which
/// grows with their angle.
struct Chain
{
  std::array<Index, ShortestChain> Ids;
  double Chord = NoChord;

  Chain() { this->Ids.fill(NoId); }
};

void Add(Chain& chain, Index id)
{
  for (Index& entry : chain.Ids)
  {
    if (id == entry)
    {
      return;
    }
    if (id < entry)
    {
      std::swap(id, entry);
    }
  }
}

/// Returns whether the edge at one carrier may continue at an adjacent one.
bool GoesOn(const Chain& a, const Chain& b)
{
  return a.Chord != NoChord && b.Chord != NoChord &&
    (a.Chord == AnyChord || b.Chord == AnyChord || std::fabs(a.Chord - b.Chord) < LargestTurn);
}

/// Nearest point to a corner found so far.
struct Bid
{
  Vector3 Corner;
  double Distance;
  Index Id;
  bool operator<(const Bid& other) const
  {
    return this->Distance != other.Distance ? this->Distance < other.Distance : this->Id < other.Id;
  }
};

/// Pair at each corner of a facet, or -1.
struct FacetPairs
{
  std::array<int, 4> At;
  int Count;
};

// Values below are one per pair, such as `points` and `ids`, the ids of their points.
using Facets = std::vector<FacetPairs>;
using Points = std::vector<FeaturePoint>;
using Ids = std::vector<Index>;

/// Translates the positions in a value.
template <class Value>
void Translate(Value&, const Vector3&)
{
}
void Translate(FeaturePoint& point, const Vector3& by)
{
  point.Corner = point.Corner + by;
}
void Translate(Bid& bid, const Vector3& by)
{
  bid.Corner = bid.Corner + by;
}

/// Sets the values of pairs at points of other ranks to the values there for the same labels.
template <class Value>
void Exchange(const SurfacePairs& pairs, std::vector<Value>& values)
{
  struct Slot
  {
    std::array<int, 2> Labels;
    Value Of;
  };
  using Slots = std::array<Slot, MaximumPairs>;
  const std::vector<std::uint32_t>& offset = pairs.Offset;
  const auto pack = [&](int mover)
  {
    Slots slots{};
    int used = 0;
    for (Index i = offset[mover]; i < offset[mover + 1] && used < MaximumPairs; ++i)
    {
      slots[used++] = { pairs.Labels[i], values[i] };
    }
    return slots;
  };
  const auto unpack = [&](int mover, const Slots& slots, const Vector3& translation)
  {
    for (Index i = offset[mover]; i < offset[mover + 1]; ++i)
    {
      const std::array<int, 2>& labels = pairs.Labels[i];
      const auto slot =
        std::find_if(slots.begin(), slots.end(), [&](const Slot& s) { return s.Labels == labels; });
      values[i] = slot != slots.end() ? slot->Of : Value{};
      Translate(values[i], translation);
    }
  };
  pairs.Exchange.SendPositions(pack, unpack);
}

/// Merges, in each round, into the value of each pair the previous values at the other
/// corners of its facets.
template <class Value, class Merge>
void Spread(const SurfacePairs& pairs, const Facets& facets, int rounds, const Merge& merge,
  std::vector<Value>& values)
{
  for (int round = 0; round < rounds; ++round)
  {
    const std::vector<Value> before = values;
    for (const FacetPairs& facet : facets)
    {
      for (int a = 0; a < facet.Count; ++a)
      {
        for (int b = 0; b < facet.Count; ++b)
        {
          if (a != b && facet.At[a] >= 0 && facet.At[b] >= 0)
          {
            merge(facet.At[a], values[facet.At[a]], before[facet.At[b]]);
          }
        }
      }
    }
    Exchange(pairs, values);
  }
}

void PickCorners(const SurfacePairs& pairs, const Facets& facets, const Ids& ids, Points& points)
{
  std::vector<Bid> bids(points.size(), Bid{ {}, CornerReach, NoId });
  for (std::size_t i = 0; i < bids.size(); ++i)
  {
    if (points[i].CornerDistance < CornerReach)
    {
      bids[i] = { points[i].Corner, points[i].CornerDistance, ids[i] };
    }
  }
  const auto merge = [&](int i, Bid& mine, const Bid& other)
  {
    const bool isOwn =
      points[i].CornerDistance >= CornerReach || Norm(other.Corner - points[i].Corner) < SameCorner;
    if (isOwn && other < mine)
    {
      mine = other;
    }
  };
  Spread(pairs, facets, CornerRings, merge, bids);
  for (std::size_t i = 0; i < bids.size(); ++i)
  {
    if (bids[i].Id == ids[i])
    {
      points[i].Kind = FeatureKind::Corner;
    }
  }
}

/// Calls visit(a, b) with the pairs at both ends of each edge of each facet.
template <class Visitor>
void ForEdges(const Facets& facets, const Visitor& visit)
{
  for (const FacetPairs& facet : facets)
  {
    for (int c = 0; c < facet.Count; ++c)
    {
      const int a = facet.At[c], b = facet.At[(c + 1) % facet.Count];
      if (a >= 0 && b >= 0)
      {
        visit(a, b);
      }
    }
  }
}

void ExchangeKinds(const SurfacePairs& pairs, Points& points)
{
  std::vector<FeatureKind> kinds(points.size());
  for (std::size_t i = 0; i < kinds.size(); ++i)
  {
    kinds[i] = points[i].Kind;
  }
  Exchange(pairs, kinds);
  for (std::size_t i = 0; i < kinds.size(); ++i)
  {
    points[i].Kind = kinds[i];
  }
}

void MakeCarriers(const SurfacePairs& pairs, const std::vector<int>& chosen, Points& points)
{
  for (int i : chosen)
  {
    points[i].Kind = FeatureKind::Edge;
  }
  ExchangeKinds(pairs, points);
}

/// Returns whether a is nearer to its edge than b is to its own; the lower id decides a tie.
bool IsNearer(const Points& points, const Ids& ids, int a, int b)
{
  const double da = points[a].EdgeDistance, db = points[b].EdgeDistance;
  return da != db ? da < db : ids[a] < ids[b];
}

/// Returns whether both ends of a mesh edge lie on one common surface.
bool ShareSide(const FeaturePoint& first, const FeaturePoint& second)
{
  const auto isOn = [](const FeaturePoint& point, const Vector3& normal)
  {
    return point.Kind == FeatureKind::Side ? Dot(point.Normal, normal) > LargestCosine
                                           : Dot(point.EdgeNormals[0], normal) > LargestCosine ||
        Dot(point.EdgeNormals[1], normal) > LargestCosine;
  };
  return first.Kind == FeatureKind::Side
    ? isOn(second, first.Normal)
    : isOn(second, first.EdgeNormals[0]) || isOn(second, first.EdgeNormals[1]);
}

void Cover(const SurfacePairs& pairs, const Facets& facets, const Ids& ids, Points& points)
{
  std::vector<int> chosen;
  const auto isSide = [&](int i) { return points[i].Kind == FeatureKind::Side; };
  const auto isEdge = [&](int i) { return points[i].Kind == FeatureKind::Edge; };
  ForEdges(facets,
    [&](int a, int b)
    {
      const bool mayCross = (isSide(a) && (isSide(b) || isEdge(b))) || (isEdge(a) && isSide(b));
      if (mayCross && !ShareSide(points[a], points[b]))
      {
        const int requested = isSide(b) && (isEdge(a) || !IsNearer(points, ids, a, b)) ? b : a;
        if (points[requested].EdgeDistance < CoverReach)
        {
          chosen.push_back(requested);
        }
      }
    });
  MakeCarriers(pairs, chosen, points);
}

bool IsCarrierAt(const Points& points, int pair)
{
  return pair >= 0 && IsCarrier(points[pair].Kind);
}

/// Marks the sides that may become carriers: none of their quads has three.
std::vector<unsigned char> FindWilling(
  const SurfacePairs& pairs, const Facets& facets, const Points& points)
{
  std::vector<unsigned char> willing(points.size());
  for (std::size_t i = 0; i < willing.size(); ++i)
  {
    const FeaturePoint& point = points[i];
    willing[i] = point.Kind == FeatureKind::Side && point.EdgeDistance < ZigzagReach;
  }
  for (const FacetPairs& facet : facets)
  {
    int carriers = 0;
    for (int c = 0; c < facet.Count; ++c)
    {
      carriers += IsCarrierAt(points, facet.At[c]);
    }
    for (int c = 0; c < facet.Count && carriers + 1 == facet.Count; ++c)
    {
      if (facet.At[c] >= 0)
      {
        willing[facet.At[c]] = 0;
      }
    }
  }
  Exchange(pairs, willing);
  return willing;
}

void StraightenZigzags(
  const SurfacePairs& pairs, const Facets& facets, const Ids& ids, Points& points)
{
  const std::vector<unsigned char> willing = FindWilling(pairs, facets, points);
  std::vector<int> chosen;
  for (const FacetPairs& facet : facets)
  {
    for (int d = 0; d < 2 && facet.Count == 4; ++d)
    {
      const int a = facet.At[1 - d], b = facet.At[3 - d];
      if (IsCarrierAt(points, facet.At[d]) && IsCarrierAt(points, facet.At[d + 2]) &&
        !IsCarrierAt(points, a) && !IsCarrierAt(points, b))
      {
        const bool mayA = a >= 0 && willing[a], mayB = b >= 0 && willing[b];
        if (mayA || mayB)
        {
          chosen.push_back(!mayB || (mayA && IsNearer(points, ids, a, b)) ? a : b);
        }
      }
    }
  }
  MakeCarriers(pairs, chosen, points);
}

void DropShortChains(
  const SurfacePairs& pairs, const Facets& facets, const Ids& ids, Points& points)
{
  std::vector<Chain> chains(points.size());
  for (std::size_t i = 0; i < chains.size(); ++i)
  {
    const FeaturePoint& point = points[i];
    if (IsCarrier(point.Kind))
    {
      chains[i].Ids[0] = ids[i];
      chains[i].Chord = point.Kind == FeatureKind::Corner
        ? AnyChord
        : Norm(point.EdgeNormals[0] - point.EdgeNormals[1]);
    }
  }
  Spread(
    pairs, facets, ChainRings,
    [](int, Chain& mine, const Chain& other)
    {
      if (GoesOn(mine, other))
      {
        std::for_each(other.Ids.begin(), other.Ids.end(), [&](Index id) { Add(mine, id); });
      }
    },
    chains);
  for (std::size_t i = 0; i < chains.size(); ++i)
  {
    if (IsCarrierAt(points, static_cast<int>(i)) && chains[i].Ids.back() == NoId)
    {
      points[i].Kind = FeatureKind::None;
    }
  }
}

void DropFarSides(const SurfacePairs& pairs, const Facets& facets, Points& points)
{
  std::vector<unsigned char> near(points.size());
  for (std::size_t i = 0; i < near.size(); ++i)
  {
    near[i] = IsCarrierAt(points, static_cast<int>(i)) || points[i].IsSheet;
  }
  Spread(
    pairs, facets, SideRings, [](int, unsigned char& mine, unsigned char other) { mine |= other; },
    near);
  for (std::size_t i = 0; i < near.size(); ++i)
  {
    if (!near[i])
    {
      points[i].Kind = FeatureKind::None;
    }
  }
}

/// Returns the pair of a mesh point that has these labels and is known, or -1.
int FindPair(const SurfacePairs& pairs, const std::vector<unsigned char>& isKnown, Index meshPoint,
  const std::array<int, 2>& labels)
{
  const int point = pairs.PointOf[meshPoint];
  if (point >= 0)
  {
    for (Index i = pairs.Offset[point]; i < pairs.Offset[point + 1]; ++i)
    {
      if (isKnown[i] && pairs.Labels[i] == labels)
      {
        return static_cast<int>(i);
      }
    }
  }
  return -1;
}

/// Lists the facets with at least one point that has a model.
Facets ListFacets(const SurfacePairs& pairs, const std::vector<unsigned char>& isKnown,
  const std::vector<Facet>& facets, const Points& points)
{
  std::vector<unsigned char> hasModel(pairs.Ids.size(), 0);
  for (std::size_t p = 0; p < hasModel.size(); ++p)
  {
    for (Index i = pairs.Offset[p]; i < pairs.Offset[p + 1]; ++i)
    {
      hasModel[p] |= points[i].Kind != FeatureKind::None;
    }
  }
  const auto isNear = [&](Index meshPoint)
  {
    const int point = pairs.PointOf[meshPoint];
    return point >= 0 && hasModel[point];
  };
  Facets found;
  for (const Facet& facet : facets)
  {
    if (facet.DomainSide >= 0 || !std::any_of(facet.Points.begin(), facet.Points.end(), isNear))
    {
      continue;
    }
    const std::array<int, 2> labels{ { std::min(facet.Materials[0], facet.Materials[1]),
      std::max(facet.Materials[0], facet.Materials[1]) } };
    FacetPairs own{ {}, CornersOf(facet.Points) };
    std::transform(facet.Points.begin(), facet.Points.end(), own.At.begin(),
      [&](Index p) { return FindPair(pairs, isKnown, p, labels); });
    found.push_back(own);
  }
  return found;
}

/// Marks the pairs that ranks exchange, MaximumPairs of each point, and sets all values to those of
/// the ranks that own them.
std::vector<unsigned char> ShareKnown(const SurfacePairs& pairs, Points& points)
{
  std::vector<unsigned char> isKnown(points.size(), 0);
  for (std::size_t p = 0; p < pairs.Ids.size(); ++p)
  {
    const Index first = pairs.Offset[p], last = pairs.Offset[p + 1];
    std::fill(
      isKnown.begin() + first, isKnown.begin() + std::min<Index>(last, first + MaximumPairs), 1);
  }
  Exchange(pairs, isKnown);
  Exchange(pairs, points);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    points[i] = isKnown[i] ? points[i] : FeaturePoint();
  }
  return isKnown;
}

/// Returns the id of the point of each pair.
Ids ListIds(const SurfacePairs& pairs, std::size_t count)
{
  Ids ids(count);
  for (std::size_t p = 0; p < pairs.Ids.size(); ++p)
  {
    std::fill(ids.begin() + pairs.Offset[p], ids.begin() + pairs.Offset[p + 1], pairs.Ids[p]);
  }
  return ids;
}

} // namespace

void ApplyFeatureRules(
  const SurfacePairs& pairs, const std::vector<Facet>& facets, std::vector<FeaturePoint>& points)
{
  const Ids ids = ListIds(pairs, points.size());
  const std::vector<unsigned char> isKnown = ShareKnown(pairs, points);
  const Facets near = ListFacets(pairs, isKnown, facets, points);
  PickCorners(pairs, near, ids, points);
  const bool isHexes = pairs.IsOfHexes;
  for (int round = 0; round < (isHexes ? HexCoverRounds : TetCoverRounds); ++round)
  {
    Cover(pairs, near, ids, points);
  }
  if (isHexes) // tets have diagonals between carriers (DiagonalFlips.h)
  {
    StraightenZigzags(pairs, near, ids, points);
  }
  DropShortChains(pairs, near, ids, points);
  DropFarSides(pairs, near, points);
}

} // namespace vfm
