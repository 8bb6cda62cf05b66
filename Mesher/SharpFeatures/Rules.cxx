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
struct RuleFacet
{
  std::array<int, 4> At;
  int Count;
};

struct Work
{
  const SurfacePairs& Pairs;
  std::vector<FeaturePoint>& Points;                          // one per pair
  std::vector<Index> Ids = std::vector<Index>(Points.size()); // id of the point of each pair
  /// Whether a pair is one of the MaximumPairs of its point that ranks exchange.
  std::vector<unsigned char> IsKnown = std::vector<unsigned char>(Points.size());
  std::vector<RuleFacet> Facets{};
};

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
void Exchange(const Work& work, std::vector<Value>& values)
{
  struct Slot
  {
    std::array<int, 2> Labels;
    Value Of;
  };
  using Slots = std::array<Slot, MaximumPairs>;
  const std::vector<std::uint32_t>& offset = work.Pairs.Offset;
  const auto pack = [&](int mover)
  {
    Slots slots{};
    int used = 0;
    for (Index i = offset[mover]; i < offset[mover + 1] && used < MaximumPairs; ++i)
    {
      slots[used++] = { work.Pairs.Labels[i], values[i] };
    }
    return slots;
  };
  const auto unpack = [&](int mover, const Slots& slots, const Vector3& translation)
  {
    for (Index i = offset[mover]; i < offset[mover + 1]; ++i)
    {
      const std::array<int, 2>& labels = work.Pairs.Labels[i];
      const auto slot =
        std::find_if(slots.begin(), slots.end(), [&](const Slot& s) { return s.Labels == labels; });
      values[i] = slot != slots.end() ? slot->Of : Value{};
      Translate(values[i], translation);
    }
  };
  work.Pairs.Exchange.SendPositions(pack, unpack);
}

/// Merges, in each round, into the value of each pair the previous values at the other
/// corners of its facets.
template <class Value, class Merge>
void Spread(const Work& work, std::vector<Value>& values, int rounds, const Merge& merge)
{
  for (int round = 0; round < rounds; ++round)
  {
    const std::vector<Value> before = values;
    for (const RuleFacet& facet : work.Facets)
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
    Exchange(work, values);
  }
}

void PickCorners(Work& work)
{
  std::vector<Bid> bids(work.Points.size(), Bid{ {}, CornerReach, NoId });
  for (std::size_t i = 0; i < bids.size(); ++i)
  {
    if (work.Points[i].CornerDistance < CornerReach)
    {
      bids[i] = { work.Points[i].Corner, work.Points[i].CornerDistance, work.Ids[i] };
    }
  }
  const auto merge = [&](int i, Bid& mine, const Bid& other)
  {
    const bool isOwn = work.Points[i].CornerDistance >= CornerReach ||
      Norm(other.Corner - work.Points[i].Corner) < SameCorner;
    if (isOwn && other < mine)
    {
      mine = other;
    }
  };
  Spread(work, bids, CornerRings, merge);
  for (std::size_t i = 0; i < bids.size(); ++i)
  {
    if (bids[i].Id == work.Ids[i])
    {
      work.Points[i].Kind = FeatureKind::Corner;
    }
  }
}

/// Calls visit(a, b) with the pairs at both ends of each edge of each facet.
template <class Visitor>
void ForEdges(const Work& work, const Visitor& visit)
{
  for (const RuleFacet& facet : work.Facets)
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

void ExchangeKinds(Work& work)
{
  std::vector<FeatureKind> kinds(work.Points.size());
  for (std::size_t i = 0; i < kinds.size(); ++i)
  {
    kinds[i] = work.Points[i].Kind;
  }
  Exchange(work, kinds);
  for (std::size_t i = 0; i < kinds.size(); ++i)
  {
    work.Points[i].Kind = kinds[i];
  }
}

void MakeCarriers(Work& work, const std::vector<int>& chosen)
{
  for (int i : chosen)
  {
    work.Points[i].Kind = FeatureKind::Edge;
  }
  ExchangeKinds(work);
}

/// Returns whether a is nearer to its edge than b is to its own; the lower id decides a tie.
bool IsNearer(const Work& work, int a, int b)
{
  const double da = work.Points[a].EdgeDistance, db = work.Points[b].EdgeDistance;
  return da != db ? da < db : work.Ids[a] < work.Ids[b];
}

/// Returns whether both ends of a mesh edge lie on one common surface.
bool ShareSide(const Work& work, int a, int b)
{
  const FeaturePoint &first = work.Points[a], &second = work.Points[b];
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

void Cover(Work& work)
{
  std::vector<int> chosen;
  const auto isSide = [&](int i) { return work.Points[i].Kind == FeatureKind::Side; };
  const auto isEdge = [&](int i) { return work.Points[i].Kind == FeatureKind::Edge; };
  ForEdges(work,
    [&](int a, int b)
    {
      const bool mayCross = (isSide(a) && (isSide(b) || isEdge(b))) || (isEdge(a) && isSide(b));
      if (mayCross && !ShareSide(work, a, b))
      {
        const int requested = isSide(b) && (isEdge(a) || !IsNearer(work, a, b)) ? b : a;
        if (work.Points[requested].EdgeDistance < CoverReach)
        {
          chosen.push_back(requested);
        }
      }
    });
  MakeCarriers(work, chosen);
}

bool IsCarrierAt(const Work& work, int pair)
{
  return pair >= 0 && IsCarrier(work.Points[pair].Kind);
}

/// Marks the sides that may become carriers: none of their quads has three.
std::vector<unsigned char> FindWilling(const Work& work)
{
  std::vector<unsigned char> willing(work.Points.size());
  for (std::size_t i = 0; i < willing.size(); ++i)
  {
    const FeaturePoint& point = work.Points[i];
    willing[i] = point.Kind == FeatureKind::Side && point.EdgeDistance < ZigzagReach;
  }
  for (const RuleFacet& facet : work.Facets)
  {
    int carriers = 0;
    for (int c = 0; c < facet.Count; ++c)
    {
      carriers += IsCarrierAt(work, facet.At[c]);
    }
    for (int c = 0; c < facet.Count && carriers + 1 == facet.Count; ++c)
    {
      if (facet.At[c] >= 0)
      {
        willing[facet.At[c]] = 0;
      }
    }
  }
  Exchange(work, willing);
  return willing;
}

void StraightenZigzags(Work& work)
{
  const std::vector<unsigned char> willing = FindWilling(work);
  std::vector<int> chosen;
  for (const RuleFacet& facet : work.Facets)
  {
    for (int d = 0; d < 2 && facet.Count == 4; ++d)
    {
      const int a = facet.At[1 - d], b = facet.At[3 - d];
      if (IsCarrierAt(work, facet.At[d]) && IsCarrierAt(work, facet.At[d + 2]) &&
        !IsCarrierAt(work, a) && !IsCarrierAt(work, b))
      {
        const bool mayA = a >= 0 && willing[a], mayB = b >= 0 && willing[b];
        if (mayA || mayB)
        {
          chosen.push_back(!mayB || (mayA && IsNearer(work, a, b)) ? a : b);
        }
      }
    }
  }
  MakeCarriers(work, chosen);
}

void DropShortChains(Work& work)
{
  std::vector<Chain> chains(work.Points.size());
  for (std::size_t i = 0; i < chains.size(); ++i)
  {
    const FeaturePoint& point = work.Points[i];
    if (IsCarrier(point.Kind))
    {
      chains[i].Ids[0] = work.Ids[i];
      chains[i].Chord = point.Kind == FeatureKind::Corner
        ? AnyChord
        : Norm(point.EdgeNormals[0] - point.EdgeNormals[1]);
    }
  }
  Spread(work, chains, ChainRings,
    [](int, Chain& mine, const Chain& other)
    {
      if (GoesOn(mine, other))
      {
        std::for_each(other.Ids.begin(), other.Ids.end(), [&](Index id) { Add(mine, id); });
      }
    });
  for (std::size_t i = 0; i < chains.size(); ++i)
  {
    if (IsCarrierAt(work, static_cast<int>(i)) && chains[i].Ids.back() == NoId)
    {
      work.Points[i].Kind = FeatureKind::None;
    }
  }
}

void DropFarSides(Work& work)
{
  std::vector<unsigned char> near(work.Points.size());
  for (std::size_t i = 0; i < near.size(); ++i)
  {
    near[i] = IsCarrierAt(work, static_cast<int>(i)) || work.Points[i].IsSheet;
  }
  Spread(
    work, near, SideRings, [](int, unsigned char& mine, unsigned char other) { mine |= other; });
  for (std::size_t i = 0; i < near.size(); ++i)
  {
    if (!near[i])
    {
      work.Points[i].Kind = FeatureKind::None;
    }
  }
}

int FindPair(const Work& work, Index meshPoint, const std::array<int, 2>& labels)
{
  const int point = work.Pairs.PointOf[meshPoint];
  if (point >= 0)
  {
    for (Index i = work.Pairs.Offset[point]; i < work.Pairs.Offset[point + 1]; ++i)
    {
      if (work.IsKnown[i] && work.Pairs.Labels[i] == labels)
      {
        return static_cast<int>(i);
      }
    }
  }
  return -1;
}

/// Lists the facets with at least one point that has a model.
void ListFacets(Work& work, const std::vector<Facet>& facets)
{
  std::vector<unsigned char> hasModel(work.Pairs.Ids.size(), 0);
  for (std::size_t p = 0; p < hasModel.size(); ++p)
  {
    for (Index i = work.Pairs.Offset[p]; i < work.Pairs.Offset[p + 1]; ++i)
    {
      hasModel[p] |= work.Points[i].Kind != FeatureKind::None;
    }
  }
  const auto isNear = [&](Index meshPoint)
  {
    const int point = work.Pairs.PointOf[meshPoint];
    return point >= 0 && hasModel[point];
  };
  for (const Facet& facet : facets)
  {
    if (facet.DomainSide >= 0 || !std::any_of(facet.Points.begin(), facet.Points.end(), isNear))
    {
      continue;
    }
    const std::array<int, 2> labels{ { std::min(facet.Materials[0], facet.Materials[1]),
      std::max(facet.Materials[0], facet.Materials[1]) } };
    RuleFacet own{ {}, facet.Points[2] == facet.Points[3] ? 3 : 4 };
    std::transform(facet.Points.begin(), facet.Points.end(), own.At.begin(),
      [&](Index p) { return FindPair(work, p, labels); });
    work.Facets.push_back(own);
  }
}

} // namespace

void ApplyFeatureRules(
  const SurfacePairs& pairs, const std::vector<Facet>& facets, std::vector<FeaturePoint>& points)
{
  Work work{ pairs, points };
  for (std::size_t p = 0; p < pairs.Ids.size(); ++p)
  {
    const Index first = pairs.Offset[p], last = pairs.Offset[p + 1];
    std::fill(work.Ids.begin() + first, work.Ids.begin() + last, pairs.Ids[p]);
    std::fill(work.IsKnown.begin() + first,
      work.IsKnown.begin() + std::min<Index>(last, first + MaximumPairs), 1);
  }
  Exchange(work, work.IsKnown);
  Exchange(work, points);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    points[i] = work.IsKnown[i] ? points[i] : FeaturePoint();
  }
  ListFacets(work, facets);
  PickCorners(work);
  const bool isHexes = work.Pairs.IsOfHexes;
  for (int round = 0; round < (isHexes ? HexCoverRounds : TetCoverRounds); ++round)
  {
    Cover(work);
  }
  if (isHexes) // tets have diagonals between carriers (DiagonalFlips.h)
  {
    StraightenZigzags(work);
  }
  DropShortChains(work);
  DropFarSides(work);
}

} // namespace vfm
