#include "Mesh/SmoothSides.h"

#include "Base/DisjointSets.h"
#include "Base/Groups.h"
#include "Base/Sorted.h"
#include "Base/Vector3.h"
#include "Labels/Fragments.h"
#include "Mesh/PointValues.h"

#include <map>
#include <tuple>

namespace vfm
{
namespace
{

using Pair = std::array<int, 2>;

constexpr int Undecided = -1;
constexpr int FewestTriangles = 12; // of a side; quads count as two
constexpr int LongestGap = 3;       // of an edge, in points from a carrier
constexpr double SharpCosine = .77; // of 40 degrees between facets at a point

/// Where a point lies on the interfaces.
enum class Place : unsigned char
{
  None,
  Inside,
  OnEdge,
  Between ///< on several surfaces
};

/// Unit, out of the larger of the two.
Vector3 NormalOf(const Mesh& mesh, const Facet& facet)
{
  const auto x = [&](int c)
  {
    const double* point = mesh.Points.data() + 3 * facet.Points[c];
    return Vector3{ { point[0], point[1], point[2] } };
  };
  const Vector3 normal = Unit(Cross(x(2) - x(0), x(3) - x(1)));
  return facet.Fragments[0] < facet.Fragments[1] ? -1.0 * normal : normal;
}

/// Two sides beside each other, the smaller first, and the largest cosine between the normals of facets at their border.
struct Contact
{
  Pair Sides;
  double Cosine;
};

using Contacts = std::map<Pair, double>;

void AddContact(const Contact& contact, Contacts& contacts)
{
  const auto at = contacts.emplace(contact.Sides, contact.Cosine).first;
  at->second = std::max(at->second, contact.Cosine);
}

/// Joins sides of few triangles with the nearest beside them until none is left that has one.
std::vector<Index> JoinSlivers(std::vector<std::int64_t> triangles, const Contacts& contacts)
{
  std::vector<Index> sets = MakeSets(triangles.size());
  for (bool changes = true; changes;)
  {
    changes = false;
    std::map<Index, std::pair<double, Index>> nearest; // of each sliver
    for (const auto& [sides, cosine] : contacts)
    {
      const Index ends[2] = { FindRoot(sets, sides[0]), FindRoot(sets, sides[1]) };
      for (int e = 0; ends[0] != ends[1] && e < 2; ++e)
      {
        if (triangles[ends[e]] < FewestTriangles)
        {
          const std::pair<double, Index> other(cosine, ends[1 - e]);
          const auto at = nearest.emplace(ends[e], other).first;
          at->second = std::max(at->second, other);
        }
      }
    }
    for (const auto& [sliver, other] : nearest)
    {
      const Index a = FindRoot(sets, sliver), b = FindRoot(sets, other.second);
      if (a != b && triangles[a] < FewestTriangles)
      {
        const std::int64_t both = triangles[a] + triangles[b];
        Join(sets, a, b);
        triangles[FindRoot(sets, a)] = both;
        changes = true;
      }
    }
  }
  return sets;
}

class SideFinder
{
public:
  SideFinder(const std::vector<Facet>& facets, const std::vector<CreaseKind>& kinds,
    const Mesh& mesh, const Partition& partition) :
    Facets(facets),
    Input(mesh),
    Parts(partition),
    Corners(mesh.CornersOfFacet()),
    Shared(this->ListPoints(), mesh, partition)
  {
    this->FindPlaces(kinds);
    this->CloseGaps();
    this->FindCut();
  }

  std::vector<int> Find()
  {
    this->NumberPoints();
    for (std::size_t f = 0; f < this->Facets.size(); ++f)
    {
      this->SideOf.push_back(this->CutOf[f] < 0 ? 0 : this->SideOfPoints(this->Facets[f]));
    }
    this->DecideOthers();
    this->JoinSides();
    return std::move(this->SideOf);
  }

private:
  bool IsInterface(const Facet& facet) const { return facet.DomainSide < 0; }

  /// The points of interfaces, ascending.
  std::vector<Index> ListPoints() const
  {
    std::vector<Index> points;
    for (const Facet& facet : this->Facets)
    {
      if (this->IsInterface(facet))
      {
        points.insert(points.end(), facet.Points.begin(), facet.Points.begin() + this->Corners);
      }
    }
    SortUnique(points);
    return points;
  }

  void FindPlaces(const std::vector<CreaseKind>& kinds)
  {
    this->PlaceOf.assign(this->Input.PointIds.size(), Place::None);
    std::vector<Pair> first(this->PlaceOf.size());
    for (const Facet& facet : this->Facets)
    {
      for (int c = 0; c < this->Corners; ++c)
      {
        const Index p = facet.Points[c];
        Place& place = this->PlaceOf[p];
        if (place == Place::None)
        {
          first[p] = SurfaceOf(facet);
          place = !kinds.empty() && IsCarrier(kinds[p]) ? Place::OnEdge : Place::Inside;
        }
        place = first[p] == SurfaceOf(facet) ? place : Place::Between;
      }
    }
    this->Shared.Fetch(
      this->PlaceOf, [this](Index point, Place place) { this->PlaceOf[point] = place; });
  }

  /// Edges go on over points that carry none but around which the facets turn, for a few points.
  void CloseGaps()
  {
    const Groups<int> around =
      this->ListAround([this](std::size_t f) { return this->IsInterface(this->Facets[f]); });
    for (int step = 0; step < LongestGap; ++step)
    {
      std::vector<Place> places(this->PlaceOf);
      for (std::size_t p = 0; p < places.size(); ++p)
      {
        const int* first = around.Items.data() + around.Begin[p];
        const int* last = around.Items.data() + around.Begin[p + 1];
        if (places[p] == Place::Inside && this->IsBesideEdge(first, last) &&
          this->IsSharp(first, last))
        {
          places[p] = Place::OnEdge;
        }
      }
      this->PlaceOf.swap(places);
      this->Shared.Fetch(
        this->PlaceOf, [this](Index point, Place place) { this->PlaceOf[point] = place; });
    }
  }

  /// The facets of a kind at each point.
  template <class Condition>
  Groups<int> ListAround(const Condition& isListed) const
  {
    return MakeGroups<int>(this->PlaceOf.size(),
      [&](const auto& visit)
      {
        for (std::size_t f = 0; f < this->Facets.size(); ++f)
        {
          for (int c = 0; isListed(f) && c < this->Corners; ++c)
          {
            visit(this->Facets[f].Points[c], static_cast<int>(f));
          }
        }
      });
  }

  bool IsBesideEdge(const int* first, const int* last) const
  {
    return std::any_of(first, last,
      [this](int f)
      {
        const std::array<Index, 4>& points = this->Facets[f].Points;
        return std::any_of(points.begin(), points.end(),
          [this](Index q) { return this->PlaceOf[q] == Place::OnEdge; });
      });
  }

  bool IsSharp(const int* first, const int* last) const
  {
    return std::any_of(first, last,
      [&](int f)
      {
        const Vector3 normal = NormalOf(this->Input, this->Facets[f]);
        return std::any_of(first, last,
          [&](int g) { return Dot(normal, NormalOf(this->Input, this->Facets[g])) < SharpCosine; });
      });
  }

  /// The interfaces with edges.
  void FindCut()
  {
    std::vector<Pair> cut;
    for (const Facet& facet : this->Facets)
    {
      if (this->IsInterface(facet) && facet.IsOwned &&
        std::any_of(facet.Points.begin(), facet.Points.end(),
          [this](Index p) { return this->PlaceOf[p] == Place::OnEdge; }))
      {
        cut.push_back(SurfaceOf(facet));
      }
    }
    SortUnique(cut);
    this->Cut = GatherItems(this->Parts.Group(), cut);
    SortUnique(this->Cut);
    for (const Facet& facet : this->Facets)
    {
      this->CutOf.push_back(static_cast<int>(FindSorted(this->Cut, SurfaceOf(facet))));
    }
  }

  /// Fills SideOfPoint, of points inside; 0 elsewhere.
  void NumberPoints()
  {
    const std::size_t count = this->PlaceOf.size();
    std::vector<Index> parent = MakeSets(count);
    std::vector<int> cutOf(count, -1);
    for (std::size_t f = 0; f < this->Facets.size(); ++f)
    {
      const std::array<Index, 4>& points = this->Facets[f].Points;
      for (int c = 0; this->CutOf[f] >= 0 && c < this->Corners; ++c)
      {
        const Index a = points[c], b = points[(c + 1) % this->Corners];
        cutOf[a] = this->PlaceOf[a] == Place::Inside ? this->CutOf[f] : -1;
        if (cutOf[a] >= 0 && this->PlaceOf[b] == Place::Inside)
        {
          Join(parent, a, b);
        }
      }
    }
    std::vector<Piece> pieces;
    std::vector<Index> pieceOf(count, -1);
    for (Index p = 0; p < static_cast<Index>(count); ++p)
    {
      const Index root = cutOf[p] >= 0 ? FindRoot(parent, p) : -1;
      if (root == p)
      {
        pieceOf[p] = static_cast<Index>(pieces.size());
        pieces.push_back({ this->Input.PointIds[p], cutOf[p] });
      }
      pieceOf[p] = root < 0 ? -1 : pieceOf[root];
    }
    this->NumberPieces(pieces, pieceOf);
  }

  void NumberPieces(const std::vector<Piece>& pieces, std::vector<Index>& pieceOf)
  {
    Ranks& ranks = this->Parts.Group();
    const Index offset = OffsetOfPieces(ranks, static_cast<Index>(pieces.size()));
    std::vector<Index> numbers(pieceOf);
    for (Index& number : numbers)
    {
      number += number < 0 ? 0 : offset;
    }
    PiecePairs same;
    this->Shared.Fetch(numbers,
      [&](Index point, Index piece)
      {
        if (piece >= 0 && numbers[point] >= 0)
        {
          same.push_back({ { numbers[point], piece } });
        }
      });
    SortUnique(same);
    const std::vector<int> sides = NumberFragments(pieces, same, offset, ranks, this->CutOfSide);
    this->PiecesEnd = static_cast<int>(this->CutOfSide.size());
    for (std::size_t cut = 0; cut < this->Cut.size(); ++cut)
    {
      this->CutOfSide.push_back(static_cast<int>(cut));
    }
    for (Index piece : pieceOf)
    {
      this->SideOfPoint.push_back(piece < 0 ? 0 : sides[piece]);
    }
  }

  int SideOfPoints(const Facet& facet) const
  {
    int side = 0;
    for (Index p : facet.Points)
    {
      const int other = this->SideOfPoint[p];
      if (side > 0 && other > 0 && other != side)
      {
        return Undecided;
      }
      side = std::max(side, other);
    }
    return side > 0 ? side : Undecided;
  }

  /// Facets whose points do not tell. Then those of them through which two parts of their side would touch in a point.
  void DecideOthers()
  {
    std::vector<int> loose;
    for (std::size_t f = 0; f < this->Facets.size(); ++f)
    {
      if (this->SideOf[f] == Undecided)
      {
        loose.push_back(static_cast<int>(f));
      }
    }
    const auto isDecided = [this](std::size_t f) { return this->SideOf[f] > 0; };
    this->Decide(loose, this->ListAround(isDecided), [](int) { return true; });
    const Groups<int> around = this->ListAround(isDecided);
    this->Decide(loose, around, [&](int f) { return this->IsPinched(f, around); });
  }

  /// The owner of a facet knows all those around it.
  template <class Condition>
  void Decide(const std::vector<int>& loose, const Groups<int>& around, const Condition& isWanted)
  {
    std::vector<int> decided(this->SideOf);
    std::vector<Decision> mine;
    for (int f : loose)
    {
      if (this->Facets[f].IsOwned && isWanted(f))
      {
        decided[f] = this->NearestSide(f, around);
        mine.push_back({ this->KeyOf(f), decided[f] });
      }
    }
    this->SideOf = std::move(decided);
    this->TakeDecisions(loose, mine);
  }

  struct Decision
  {
    std::array<Index, 4> Facet; // ids of its points, ascending
    Index Side;
    bool operator<(const Decision& other) const { return this->Facet < other.Facet; }
  };

  std::array<Index, 4> KeyOf(std::size_t f) const
  {
    std::array<Index, 4> key;
    std::transform(this->Facets[f].Points.begin(), this->Facets[f].Points.end(), key.begin(),
      [this](Index p) { return this->Input.PointIds[p]; });
    std::sort(key.begin(), key.end());
    return key;
  }

  /// Another side around a facet than its own, that which has most of its edges, the nearest normal where several do. Where there is none:
  /// what is left of the interface is one more side.
  int NearestSide(std::size_t f, const Groups<int>& around) const
  {
    struct Around
    {
      int Edges = 0;
      double Cosine = -2.0;
    };
    std::map<int, Around> sides;
    const Vector3 normal = NormalOf(this->Input, this->Facets[f]);
    for (int other : this->ListBeside(f, around))
    {
      Around& side = sides[this->SideOf[other]];
      side.Edges += this->ShareEdge(f, other);
      side.Cosine = std::max(side.Cosine, Dot(normal, NormalOf(this->Input, this->Facets[other])));
    }
    const int own = this->SideOf[f];
    const int rest = own > 0 ? own : this->PiecesEnd + this->CutOf[f];
    std::tuple<int, double, int> nearest(-1, 0.0, -rest);
    for (const auto& [side, its] : sides)
    {
      if (side != own)
      {
        nearest = std::max(nearest, { its.Edges, its.Cosine, -side });
      }
    }
    return -std::get<2>(nearest);
  }

  /// Whether facets of its side at one of its points are not joined to it over edges there.
  bool IsPinched(int f, const Groups<int>& around) const
  {
    return std::any_of(this->Facets[f].Points.begin(), this->Facets[f].Points.end(),
      [&](Index p)
      {
        std::vector<int> joined{ f }, apart;
        std::copy_if(around.Items.data() + around.Begin[p],
          around.Items.data() + around.Begin[p + 1], std::back_inserter(apart),
          [&](int g) { return g != f && this->SideOf[g] == this->SideOf[f]; });
        for (std::size_t next = 0; next < joined.size(); ++next)
        {
          const auto rest = std::partition(
            apart.begin(), apart.end(), [&](int g) { return !this->ShareEdge(joined[next], g); });
          joined.insert(joined.end(), rest, apart.end());
          apart.erase(rest, apart.end());
        }
        return !apart.empty();
      });
  }

  /// The facets of the same interface at its points.
  std::vector<int> ListBeside(std::size_t f, const Groups<int>& around) const
  {
    std::vector<int> beside;
    for (Index p : this->Facets[f].Points)
    {
      std::copy_if(around.Items.data() + around.Begin[p], around.Items.data() + around.Begin[p + 1],
        std::back_inserter(beside),
        [&](int other) { return this->CutOf[other] == this->CutOf[f]; });
    }
    SortUnique(beside);
    return beside;
  }

  bool ShareEdge(std::size_t f, std::size_t g) const
  {
    const auto begin = this->Facets[g].Points.begin(), end = begin + this->Corners;
    return std::count_if(this->Facets[f].Points.begin(),
             this->Facets[f].Points.begin() + this->Corners,
             [&](Index p) { return std::find(begin, end, p) != end; }) > 1;
  }

  void TakeDecisions(const std::vector<int>& loose, const std::vector<Decision>& mine)
  {
    const std::vector<Bytes> messages(this->Parts.Peers().size(), ToBytes(mine));
    std::vector<Decision> told;
    for (const Bytes& bytes : this->Parts.Group().Exchange(this->Parts.Peers(), messages))
    {
      const std::vector<Decision> theirs = FromBytes<Decision>(bytes);
      told.insert(told.end(), theirs.begin(), theirs.end());
    }
    std::sort(told.begin(), told.end());
    for (int f : loose)
    {
      const Decision key{ this->KeyOf(f), 0 };
      const auto at = std::lower_bound(told.begin(), told.end(), key);
      if (at != told.end() && at->Facet == key.Facet)
      {
        this->SideOf[f] = static_cast<int>(at->Side);
      }
      else if (this->SideOf[f] == Undecided) // beyond the rim nobody may have decided
      {
        this->SideOf[f] = this->PiecesEnd + this->CutOf[f];
      }
    }
  }

  void JoinSides()
  {
    Ranks& ranks = this->Parts.Group();
    std::vector<std::int64_t> triangles(this->CutOfSide.size(), 0);
    for (std::size_t f = 0; f < this->Facets.size(); ++f)
    {
      triangles[this->SideOf[f]] += this->Facets[f].IsOwned ? this->Corners - 2 : 0;
    }
    ranks.Sum(triangles);
    std::vector<Contact> contacts;
    for (const auto& contact : this->FindContacts())
    {
      const Pair& sides = contact.first;
      if (std::min(triangles[sides[0]], triangles[sides[1]]) < FewestTriangles)
      {
        contacts.push_back({ sides, contact.second });
      }
    }
    Contacts all;
    for (const Contact& contact : GatherItems(ranks, contacts))
    {
      AddContact(contact, all);
    }
    std::vector<Index> sets = JoinSlivers(triangles, all);
    std::vector<int> parts(this->Cut.size(), 0); // sides of each interface
    for (std::size_t side = 1; side < sets.size(); ++side)
    {
      parts[this->CutOfSide[side]] +=
        triangles[side] > 0 && FindRoot(sets, side) == static_cast<Index>(side);
    }
    for (std::size_t f = 0; f < this->Facets.size(); ++f)
    {
      const bool isCut = this->CutOf[f] >= 0 && parts[this->CutOf[f]] > 1;
      this->SideOf[f] = isCut ? static_cast<int>(FindRoot(sets, this->SideOf[f])) : 0;
    }
  }

  /// Between facets of which this rank owns one.
  Contacts FindContacts() const
  {
    struct Border
    {
      std::array<Index, 2> Points;
      std::size_t Facet;
      bool operator<(const Border& other) const { return this->Points < other.Points; }
    };
    std::vector<Border> borders;
    for (std::size_t f = 0; f < this->Facets.size(); ++f)
    {
      const std::array<Index, 4>& points = this->Facets[f].Points;
      for (int c = 0; this->CutOf[f] >= 0 && c < this->Corners; ++c)
      {
        const Index a = points[c], b = points[(c + 1) % this->Corners];
        if (this->PlaceOf[a] != Place::Inside || this->PlaceOf[b] != Place::Inside)
        {
          borders.push_back({ { { std::min(a, b), std::max(a, b) } }, f });
        }
      }
    }
    std::sort(borders.begin(), borders.end());
    Contacts contacts;
    for (auto first = borders.begin(), last = first; first != borders.end(); first = last)
    {
      last = std::upper_bound(first, borders.end(), *first);
      for (auto a = first; a != last; ++a)
      {
        for (auto b = a + 1; b != last; ++b)
        {
          this->AddContactOf(a->Facet, b->Facet, contacts);
        }
      }
    }
    return contacts;
  }

  void AddContactOf(std::size_t f, std::size_t g, Contacts& contacts) const
  {
    const Pair sides{ { std::min(this->SideOf[f], this->SideOf[g]),
      std::max(this->SideOf[f], this->SideOf[g]) } };
    if (sides[0] != sides[1] && this->CutOf[f] == this->CutOf[g] &&
      (this->Facets[f].IsOwned || this->Facets[g].IsOwned))
    {
      const double cosine =
        Dot(NormalOf(this->Input, this->Facets[f]), NormalOf(this->Input, this->Facets[g]));
      AddContact({ sides, cosine }, contacts);
    }
  }

  const std::vector<Facet>& Facets;
  const Mesh& Input;
  const Partition& Parts;
  const int Corners; // of a facet
  const PointValues Shared;
  std::vector<Place> PlaceOf;   // of every point
  std::vector<Pair> Cut;        // interfaces with edges, ascending
  std::vector<int> CutOf;       // of every facet: position in Cut, or -1
  std::vector<int> SideOfPoint; // 0: none
  std::vector<int> CutOfSide;   // [0] unused; those of pieces, then one more of each interface
  int PiecesEnd = 0;
  std::vector<int> SideOf; // of every facet
};

} // namespace

std::vector<int> FindSmoothSides(const std::vector<Facet>& facets,
  const std::vector<CreaseKind>& kinds, const Mesh& mesh, const Partition& partition)
{
  if (!partition.Group().Any(std::any_of(kinds.begin(), kinds.end(), IsCarrier)))
  {
    return std::vector<int>(facets.size(), 0);
  }
  return SideFinder(facets, kinds, mesh, partition).Find();
}

} // namespace vfm
