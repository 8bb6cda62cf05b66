#include "Report/Fragments/PeriodicPieces.h"

#include "Base/DisjointSets.h"
#include "Base/Sorted.h"
#include "Elements/EqualFaces.h"
#include "Ranks/AskRanks.h"
#include "Ranks/MeetingRank.h"
#include "Ranks/WorkTogether.h"
#include "Report/DomainSides.h"
#include "Report/ElementCorners.h"
#include "Report/FlatData.h"
#include "Report/MatchFaces.h"

#include <map>

namespace vfm
{
namespace
{

// The number of a face here is FacePlaces::End * element + where the element has it. The ids of its
// points are those of the lowest copies, so copies of a face have the same.

Index ElementOf(const NumberedFace& face)
{
  return face.Number / FacePlaces::End;
}

Index PlaceOf(const NumberedFace& face)
{
  return face.Number % FacePlaces::End;
}

/// Lists the faces of elements.
class FaceLister
{
public:
  explicit FaceLister(const MeshData& mesh) : TheMesh(mesh), Corners(mesh), Places(mesh) {}

  /// Appends the faces of an element.
  void Append(Index element, std::vector<NumberedFace>& faces) const
  {
    const MeshData& mesh = this->TheMesh;
    const Index* ids = mesh.PeriodicPartner ? mesh.PeriodicPartner : mesh.PointIds;
    const std::array<Vector3, 8> corners = this->Corners.Find(element);
    const Index numbers[] = { 0, 1, 2, 3, 4, 5, 6, 7 };
    for (int side = 0; side < SidesOf(mesh); ++side)
    {
      std::vector<Vector3> positions;
      for (Index corner : ValuesOfSide(mesh, numbers, side))
      {
        if (corner >= 0)
        {
          positions.push_back(corners[corner]);
        }
      }
      const FaceIds points = PointsOfSide(mesh, { element, side });
      faces.push_back(
        { SortedIds(points, ids), FacePlaces::End * element + this->Places.Of(positions) });
    }
  }

private:
  const MeshData& TheMesh;
  const ElementCorners Corners;
  const FacePlaces Places;
};

/// Collective. Returns the value of the element behind each face.
std::vector<Index> ValuesBehind(
  const std::vector<NumberedFace>& faces, const std::vector<Index>& valueOfElement, Ranks& ranks)
{
  std::vector<FaceIds> ids;
  std::vector<Index> values;
  for (const NumberedFace& face : faces)
  {
    ids.push_back(face.Points);
    values.push_back(valueOfElement[ElementOf(face)] * FacePlaces::End + PlaceOf(face));
  }
  return MatchFaces(ids, values, ranks);
}

/// Collective. Returns the faces between two elements of one fragment.
std::vector<NumberedFace> FindInnerFaces(const MeshData& mesh, Ranks& ranks)
{
  const FaceLister lister(mesh);
  std::vector<NumberedFace> faces;
  for (Index element = 0; element < mesh.NumberOfElements; ++element)
  {
    lister.Append(element, faces);
  }
  const std::vector<Index> fragments(mesh.Fragment, mesh.Fragment + mesh.NumberOfElements);
  const std::vector<Index> behind = ValuesBehind(faces, fragments, ranks);
  std::vector<NumberedFace> inner;
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    if (behind[f] != NothingBehind && behind[f] / FacePlaces::End == fragments[ElementOf(faces[f])])
    {
      inner.push_back(faces[f]);
    }
  }
  return inner;
}

/// Collective. Joins the elements of this rank that are connected at the same copy of a face.
/// Returns the lowest element id of the piece of each element.
/// @param faces removes the faces between joined elements
std::vector<Index> FindPieces(const MeshData& mesh, std::vector<NumberedFace>& faces, Ranks& ranks)
{
  std::vector<Index> numbers(mesh.NumberOfElements); // of elements on all ranks
  for (Index element = 0; element < mesh.NumberOfElements; ++element)
  {
    numbers[element] = element * ranks.Count() + ranks.Rank();
  }
  const std::vector<Index> behind = ValuesBehind(faces, numbers, ranks);
  std::vector<Index> sets = MakeSets(numbers.size());
  std::vector<NumberedFace> open;
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    const Index other = behind[f] / FacePlaces::End;
    if (other % ranks.Count() == ranks.Rank() && behind[f] % FacePlaces::End == PlaceOf(faces[f]))
    {
      Join(sets, ElementOf(faces[f]), other / ranks.Count());
    }
    else
    {
      open.push_back(faces[f]);
    }
  }
  faces = std::move(open);
  std::vector<Index> pieces(mesh.ElementIds, mesh.ElementIds + mesh.NumberOfElements);
  for (Index element = 0; element < mesh.NumberOfElements; ++element)
  {
    Index& lowest = pieces[FindRoot(sets, element)];
    lowest = std::min(lowest, mesh.ElementIds[element]);
  }
  for (Index element = 0; element < mesh.NumberOfElements; ++element)
  {
    pieces[element] = pieces[FindRoot(sets, element)];
  }
  return pieces;
}

using Link = std::array<Index, 5>; // two pieces, and the periods by which the second is moved

/// Returns the links of pieces of this rank.
/// @pre Collective
std::vector<Link> FindLinks(
  const std::vector<NumberedFace>& faces, const std::vector<Index>& pieces, Ranks& ranks)
{
  const std::vector<Index> behind = ValuesBehind(faces, pieces, ranks);
  std::vector<Link> links;
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    const Index3 periods =
      FacePlaces::PeriodsBetween(behind[f] % FacePlaces::End, PlaceOf(faces[f]));
    links.push_back({ { pieces[ElementOf(faces[f])], behind[f] / FacePlaces::End, periods[0],
      periods[1], periods[2] } });
  }
  SortUnique(links);
  return links;
}

/// Moves pieces so that they fit together.
class PieceMoves
{
public:
  /// @param links  all links of some fragments, ascending
  explicit PieceMoves(const std::vector<Link>& links)
  {
    for (const Link& link : links) // so each fragment begins with its lowest piece
    {
      this->LinksOf[link[0]].push_back(link);
    }
    for (const auto& entry : this->LinksOf)
    {
      if (this->Periods.count(entry.first) == 0)
      {
        this->MoveFragment(entry.first);
      }
    }
  }

  /// Returns the periods by which a piece is moved.
  Index3 Of(Index piece) const
  {
    const auto found = this->Periods.find(piece);
    return found == this->Periods.end() ? Index3{ { 0, 0, 0 } } : found->second;
  }

private:
  void MoveFragment(Index first)
  {
    std::vector<Index> pieces{ first };
    this->Periods[first] = { { 0, 0, 0 } };
    bool fits = true;
    for (std::size_t p = 0; p < pieces.size(); ++p)
    {
      for (const Link& link : this->LinksOf.at(pieces[p]))
      {
        Index3 periods = this->Periods[pieces[p]];
        for (int a = 0; a < 3; ++a)
        {
          periods[a] += link[2 + a];
        }
        const auto [place, isNew] = this->Periods.emplace(link[1], periods);
        fits = fits && place->second == periods;
        if (isNew)
        {
          pieces.push_back(link[1]);
        }
      }
    }
    for (std::size_t p = 0; !fits && p < pieces.size(); ++p)
    {
      this->Periods[pieces[p]] = { { 0, 0, 0 } };
    }
  }

  std::map<Index, std::vector<Link>> LinksOf;
  std::map<Index, Index3> Periods;
};

/// Returns the periods by which each element is moved. A rank, which the fragment determines, finds
/// those of all pieces of the fragment.
/// @pre Collective
std::vector<Index3> FindPeriods(const MeshData& mesh, const std::vector<Index>& pieces,
  const std::vector<Link>& links, Ranks& ranks)
{
  using OfFragment = std::array<Index, 2>; // fragment and piece
  std::vector<OfFragment> asked;
  for (std::size_t e = 0; e < pieces.size(); ++e)
  {
    const OfFragment piece{ { mesh.Fragment[e], pieces[e] } };
    if (asked.empty() || asked.back() != piece)
    {
      asked.push_back(piece);
    }
  }
  SortUnique(asked);
  std::map<Index, Index> fragmentOf;
  for (const auto& [fragment, piece] : asked)
  {
    fragmentOf[piece] = fragment;
  }
  const auto rankOf = [&ranks](Index fragment) { return MeetingRank(fragment, ranks.Count()); };
  std::vector<Link> known = SendItems(
    links, [&](const Link& link) { return rankOf(fragmentOf.at(link[0])); }, ranks);
  SortUnique(known);
  const PieceMoves moves(known);
  const std::vector<Index3> found = AskRanks(
    asked, [&](const OfFragment& piece) { return rankOf(piece[0]); },
    [&moves](const std::vector<OfFragment>& questions)
    {
      std::vector<Index3> answers;
      for (const OfFragment& piece : questions)
      {
        answers.push_back(moves.Of(piece[1]));
      }
      return answers;
    },
    ranks);
  std::vector<Index3> periods;
  for (std::size_t e = 0; e < pieces.size(); ++e)
  {
    periods.push_back(found[FindSorted(asked, OfFragment{ { mesh.Fragment[e], pieces[e] } })]);
  }
  return periods;
}

Vector3 TranslationBy(
  const Index3& periods, const std::vector<double>& lengths, const ImageFrame& frame)
{
  Vector3 own = frame.Origin;
  for (int a = 0; a < 3; ++a)
  {
    own[a] += static_cast<double>(periods[a]) * lengths[a];
  }
  return frame.ToSpace(own) - frame.Origin;
}

} // namespace

std::vector<Vector3> FindTranslations(const MeshData& mesh, Ranks& ranks)
{
  const std::vector<double> lengths = NumbersOfField(mesh.Fields, "PeriodLengths");
  if (!ranks.Any(lengths.size() == 3))
  {
    return {};
  }
  WorkTogether(ranks,
    [&mesh]
    {
      Require(mesh.PointIds, "GlobalPointIds", mesh);
      Require(mesh.ElementIds, "GlobalCellIds", mesh);
    });
  std::vector<NumberedFace> faces = FindInnerFaces(mesh, ranks);
  const std::vector<Index> pieces = FindPieces(mesh, faces, ranks);
  const std::vector<Link> links = FindLinks(faces, pieces, ranks);
  const ImageFrame frame = FrameOfDomain(mesh);
  std::vector<Vector3> translations;
  for (const Index3& periods : FindPeriods(mesh, pieces, links, ranks))
  {
    translations.push_back(TranslationBy(periods, lengths, frame));
  }
  return translations;
}

} // namespace vfm
