#include "Creases/Rules.h"

#include <limits>

namespace vfm
{
namespace
{

constexpr double LargestCosine = 0.883; // between the normals of two sides: 28 degrees
constexpr double CoverReach = 1.6; // of an edge from a point that is asked to carry it, in cells
constexpr int HexCoverRounds = 1,
              TetCoverRounds = 3;   // the first sees sides alone; hexes suffer where carriers crowd
constexpr double ZigzagReach = 1.2; // the same where only the shape of the chain asks
constexpr double CornerReach = 2.0;
constexpr double SameCorner = 1.0; // distance of two models' corners that are one, in mean cells
constexpr int CornerRings = 3;     // of facets
constexpr std::size_t ShortestChain = 9; // carriers
constexpr double LargestTurn =
  0.2; // between the chords of an edge at two carriers beside each other
constexpr int ChainRings = 8, SideRings = 3;
constexpr int MostPairs = 3; // of labels with edges at one point
constexpr Index NoId = std::numeric_limits<Index>::max();

constexpr double NoChord = -1.0, AnyChord = 10.0; // of points that carry nothing, of corners

/// A piece of an edge: the lowest ids of its carriers that one of them knows of, ascending, and the chord between the unit normals
/// of its surfaces there, which grows with the angle.
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

/// Whether the edge at one carrier may be that at another beside it.
bool GoesOn(const Chain& a, const Chain& b)
{
  return a.Chord != NoChord && b.Chord != NoChord &&
    (a.Chord == AnyChord || b.Chord == AnyChord || std::fabs(a.Chord - b.Chord) < LargestTurn);
}

/// Who is nearest to a corner, as far as is known.
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

/// The pairs at the corners of a facet, -1: none.
struct RuleFacet
{
  std::array<int, 4> At;
  int Count;
};

class CreaseRules
{
public:
  CreaseRules(
    const SurfacePairs& pairs, const std::vector<Facet>& facets, std::vector<CreasePoint>& points);
  void Run();

private:
  int FindPair(Index meshPoint, const std::array<int, 2>& labels) const;
  void ListFacets(const std::vector<Facet>& facets);
  template <class Value>
  void Exchange(std::vector<Value>& values) const;
  template <class Value, class Merge>
  void Spread(std::vector<Value>& values, int rounds, const Merge& merge) const;
  template <class Visitor>
  void ForEdges(const Visitor& visit) const;
  void MakeCarriers(const std::vector<int>& chosen);
  void ExchangeKinds();
  bool IsCarrierAt(int pair) const { return pair >= 0 && IsCarrier(this->Points[pair].Kind); }
  bool IsNearer(int a, int b) const;
  bool ShareSide(int a, int b) const;
  std::vector<unsigned char> FindWilling() const;

  void PickCorners();
  void Cover();
  void StraightenZigzags();
  void DropShortChains();
  void DropFarSides();

  const SurfacePairs& Pairs;
  std::vector<CreasePoint>& Points; // of each pair
  std::vector<Index> Ids;           // of the point of each pair
  std::vector<unsigned char>
    IsKnown; // of each pair: it is among those of the point that ranks tell each other
  std::vector<RuleFacet> Facets;
};

CreaseRules::CreaseRules(
  const SurfacePairs& pairs, const std::vector<Facet>& facets, std::vector<CreasePoint>& points) :
  Pairs(pairs), Points(points), Ids(points.size()), IsKnown(points.size(), 0)
{
  for (std::size_t p = 0; p < pairs.Ids.size(); ++p)
  {
    const Index first = pairs.Offset[p], last = pairs.Offset[p + 1];
    std::fill(this->Ids.begin() + first, this->Ids.begin() + last, pairs.Ids[p]);
    std::fill(this->IsKnown.begin() + first,
      this->IsKnown.begin() + std::min<Index>(last, first + MostPairs), 1);
  }
  this->Exchange(this->IsKnown);
  this->Exchange(this->Points);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    points[i] = this->IsKnown[i] ? points[i] : CreasePoint();
  }
  this->ListFacets(facets);
}

int CreaseRules::FindPair(Index meshPoint, const std::array<int, 2>& labels) const
{
  const int point = this->Pairs.PointOf[meshPoint];
  if (point >= 0)
  {
    for (Index i = this->Pairs.Offset[point]; i < this->Pairs.Offset[point + 1]; ++i)
    {
      if (this->IsKnown[i] && this->Pairs.Labels[i] == labels)
      {
        return static_cast<int>(i);
      }
    }
  }
  return -1;
}

/// Those with a point that has a model.
void CreaseRules::ListFacets(const std::vector<Facet>& facets)
{
  std::vector<unsigned char> hasModel(this->Pairs.Ids.size(), 0);
  for (std::size_t p = 0; p < hasModel.size(); ++p)
  {
    for (Index i = this->Pairs.Offset[p]; i < this->Pairs.Offset[p + 1]; ++i)
    {
      hasModel[p] |= this->Points[i].Kind != CreaseKind::None;
    }
  }
  const auto isNear = [&](Index meshPoint)
  {
    const int point = this->Pairs.PointOf[meshPoint];
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
      [&](Index p) { return this->FindPair(p, labels); });
    this->Facets.push_back(own);
  }
}

/// Gives the pairs of points of other ranks the values that these have for the same labels.
template <class Value>
void CreaseRules::Exchange(std::vector<Value>& values) const
{
  struct Slot
  {
    std::array<int, 2> Labels;
    Value Of;
  };
  using Slots = std::array<Slot, MostPairs>;
  const std::vector<Index>& offset = this->Pairs.Offset;
  const auto pack = [&](int mover)
  {
    Slots slots{};
    int used = 0;
    for (Index i = offset[mover]; i < offset[mover + 1] && used < MostPairs; ++i)
    {
      slots[used++] = { this->Pairs.Labels[i], values[i] };
    }
    return slots;
  };
  const auto unpack = [&](int mover, const Slots& slots)
  {
    for (Index i = offset[mover]; i < offset[mover + 1]; ++i)
    {
      const std::array<int, 2>& labels = this->Pairs.Labels[i];
      const auto slot =
        std::find_if(slots.begin(), slots.end(), [&](const Slot& s) { return s.Labels == labels; });
      values[i] = slot != slots.end() ? slot->Of : Value{};
    }
  };
  this->Pairs.Exchange.SendAll(pack, unpack);
}

/// In each round every point merges the values that those of its facets had before.
template <class Value, class Merge>
void CreaseRules::Spread(std::vector<Value>& values, int rounds, const Merge& merge) const
{
  for (int round = 0; round < rounds; ++round)
  {
    const std::vector<Value> before = values;
    for (const RuleFacet& facet : this->Facets)
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
    this->Exchange(values);
  }
}

/// Calls visit(a, b) with the pairs at both ends of the edges of facets.
template <class Visitor>
void CreaseRules::ForEdges(const Visitor& visit) const
{
  for (const RuleFacet& facet : this->Facets)
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

void CreaseRules::ExchangeKinds()
{
  std::vector<CreaseKind> kinds(this->Points.size());
  for (std::size_t i = 0; i < kinds.size(); ++i)
  {
    kinds[i] = this->Points[i].Kind;
  }
  this->Exchange(kinds);
  for (std::size_t i = 0; i < kinds.size(); ++i)
  {
    this->Points[i].Kind = kinds[i];
  }
}

void CreaseRules::MakeCarriers(const std::vector<int>& chosen)
{
  for (int i : chosen)
  {
    this->Points[i].Kind = CreaseKind::Edge;
  }
  this->ExchangeKinds();
}

/// Whether a is nearer to its edge than b is to its.
bool CreaseRules::IsNearer(int a, int b) const
{
  const double da = this->Points[a].EdgeDistance, db = this->Points[b].EdgeDistance;
  return da != db ? da < db : this->Ids[a] < this->Ids[b];
}

void CreaseRules::PickCorners()
{
  std::vector<Bid> bids(this->Points.size(), Bid{ {}, CornerReach, NoId });
  for (std::size_t i = 0; i < bids.size(); ++i)
  {
    if (this->Points[i].CornerDistance < CornerReach)
    {
      bids[i] = { this->Points[i].Corner, this->Points[i].CornerDistance, this->Ids[i] };
    }
  }
  const auto merge = [this](int i, Bid& mine, const Bid& other)
  {
    const bool isMine = this->Points[i].CornerDistance >= CornerReach ||
      Norm(other.Corner - this->Points[i].Corner) < SameCorner;
    if (isMine && other < mine)
    {
      mine = other;
    }
  };
  this->Spread(bids, CornerRings, merge);
  for (std::size_t i = 0; i < bids.size(); ++i)
  {
    if (bids[i].Id == this->Ids[i])
    {
      this->Points[i].Kind = CreaseKind::Corner;
    }
  }
}

/// Whether some surface holds for both ends of a mesh edge.
bool CreaseRules::ShareSide(int a, int b) const
{
  const CreasePoint &first = this->Points[a], &second = this->Points[b];
  const auto isOn = [](const CreasePoint& point, const Vector3& normal)
  {
    return point.Kind == CreaseKind::Side ? Dot(point.Normal, normal) > LargestCosine
                                          : Dot(point.EdgeNormals[0], normal) > LargestCosine ||
        Dot(point.EdgeNormals[1], normal) > LargestCosine;
  };
  return first.Kind == CreaseKind::Side
    ? isOn(second, first.Normal)
    : isOn(second, first.EdgeNormals[0]) || isOn(second, first.EdgeNormals[1]);
}

void CreaseRules::Cover()
{
  std::vector<int> chosen;
  const auto isSide = [this](int i) { return this->Points[i].Kind == CreaseKind::Side; };
  const auto isEdge = [this](int i) { return this->Points[i].Kind == CreaseKind::Edge; };
  this->ForEdges(
    [&](int a, int b)
    {
      const bool mayCross = (isSide(a) && (isSide(b) || isEdge(b))) || (isEdge(a) && isSide(b));
      if (mayCross && !this->ShareSide(a, b))
      {
        const int asked = isSide(b) && (isEdge(a) || !this->IsNearer(a, b)) ? b : a;
        if (this->Points[asked].EdgeDistance < CoverReach)
        {
          chosen.push_back(asked);
        }
      }
    });
  this->MakeCarriers(chosen);
}

/// Sides that may become carriers: none of their quads has three.
std::vector<unsigned char> CreaseRules::FindWilling() const
{
  std::vector<unsigned char> willing(this->Points.size());
  for (std::size_t i = 0; i < willing.size(); ++i)
  {
    const CreasePoint& point = this->Points[i];
    willing[i] = point.Kind == CreaseKind::Side && point.EdgeDistance < ZigzagReach;
  }
  for (const RuleFacet& facet : this->Facets)
  {
    int carriers = 0;
    for (int c = 0; c < facet.Count; ++c)
    {
      carriers += this->IsCarrierAt(facet.At[c]);
    }
    for (int c = 0; c < facet.Count && carriers + 1 == facet.Count; ++c)
    {
      if (facet.At[c] >= 0)
      {
        willing[facet.At[c]] = 0;
      }
    }
  }
  this->Exchange(willing);
  return willing;
}

void CreaseRules::StraightenZigzags()
{
  const std::vector<unsigned char> willing = this->FindWilling();
  std::vector<int> chosen;
  for (const RuleFacet& facet : this->Facets)
  {
    for (int d = 0; d < 2 && facet.Count == 4; ++d)
    {
      const int a = facet.At[1 - d], b = facet.At[3 - d];
      if (this->IsCarrierAt(facet.At[d]) && this->IsCarrierAt(facet.At[d + 2]) &&
        !this->IsCarrierAt(a) && !this->IsCarrierAt(b))
      {
        const bool mayA = a >= 0 && willing[a], mayB = b >= 0 && willing[b];
        if (mayA || mayB)
        {
          chosen.push_back(!mayB || (mayA && this->IsNearer(a, b)) ? a : b);
        }
      }
    }
  }
  this->MakeCarriers(chosen);
}

void CreaseRules::DropShortChains()
{
  std::vector<Chain> chains(this->Points.size());
  for (std::size_t i = 0; i < chains.size(); ++i)
  {
    const CreasePoint& point = this->Points[i];
    if (IsCarrier(point.Kind))
    {
      chains[i].Ids[0] = this->Ids[i];
      chains[i].Chord = point.Kind == CreaseKind::Corner
        ? AnyChord
        : Norm(point.EdgeNormals[0] - point.EdgeNormals[1]);
    }
  }
  this->Spread(chains, ChainRings,
    [](int, Chain& mine, const Chain& other)
    {
      if (GoesOn(mine, other))
      {
        std::for_each(other.Ids.begin(), other.Ids.end(), [&](Index id) { Add(mine, id); });
      }
    });
  for (std::size_t i = 0; i < chains.size(); ++i)
  {
    if (this->IsCarrierAt(static_cast<int>(i)) && chains[i].Ids.back() == NoId)
    {
      this->Points[i].Kind = CreaseKind::None;
    }
  }
}

void CreaseRules::DropFarSides()
{
  std::vector<unsigned char> near(this->Points.size());
  for (std::size_t i = 0; i < near.size(); ++i)
  {
    near[i] = this->IsCarrierAt(static_cast<int>(i)) || this->Points[i].IsSheet;
  }
  this->Spread(
    near, SideRings, [](int, unsigned char& mine, unsigned char other) { mine |= other; });
  for (std::size_t i = 0; i < near.size(); ++i)
  {
    if (!near[i])
    {
      this->Points[i].Kind = CreaseKind::None;
    }
  }
}

void CreaseRules::Run()
{
  this->PickCorners();
  const bool isHexes = this->Pairs.IsOfHexes;
  for (int round = 0; round < (isHexes ? HexCoverRounds : TetCoverRounds); ++round)
  {
    this->Cover();
  }
  if (isHexes) // tets have diagonals between carriers (DiagonalFlips.h)
  {
    this->StraightenZigzags();
  }
  this->DropShortChains();
  this->DropFarSides();
}

} // namespace

void ApplyCreaseRules(
  const SurfacePairs& pairs, const std::vector<Facet>& facets, std::vector<CreasePoint>& points)
{
  CreaseRules(pairs, facets, points).Run();
}

} // namespace vfm
