#include "Modify/NodeCopies.h"

#include "Base/DisjointSets.h"
#include "Base/Sorted.h"
#include "Elements/EqualFaces.h"
#include "Modify/GreatestId.h"
#include "Ranks/AskRanks.h"
#include "Ranks/MergeByKey.h"
#include "Ranks/NumberKeys.h"
#include "Report/FlatData.h"
#include "Report/MatchFaces.h"
#include "Report/Sets/MeshSets.h"

#include <limits>
#include <tuple>

namespace vfm
{
namespace
{

/// A corner of an element of this rank at a node of a cut face.
struct Corner
{
  Index Node, Element; // point of the mesh, element
  Index Place;         // index in MeshData::Elements
};

/// Elements of a rank at a node that are connected by faces of this rank.
struct Part
{
  Index Class;   // PeriodicPartner of the node, or its id
  Index Node;    // global id
  Index Element; // lowest global id
  auto operator<=>(const Part&) const = default;
};

/// A part with a face behind which an element of another rank or of the opposite side may be.
struct PartLink
{
  Part Of;
  FaceIds Face; // sorted classes of its nodes
};

/// The copy of the node of a part.
struct PartCopy
{
  Index Id, Partner;
};

const Index* ClassesOf(const MeshData& mesh)
{
  return mesh.PeriodicPartner ? mesh.PeriodicPartner : mesh.PointIds;
}

std::vector<char> MarkOwnNodes(const MeshData& mesh, const std::vector<char>& isCut)
{
  std::vector<char> isMarked(mesh.NumberOfPoints, 0);
  for (std::size_t f = 0; f < isCut.size(); ++f)
  {
    const MeshFacet& facet = (*mesh.Facets)[f];
    for (Index point : PointsOfSide(mesh, facet))
    {
      if (isCut[f] != 0 && point >= 0)
      {
        isMarked[point] = 1;
      }
    }
  }
  return isMarked;
}

/// Marks the points of cut faces, also of faces on other ranks and on opposite sides.
std::vector<char> MarkNodes(const MeshData& mesh, const std::vector<char>& isCut, Ranks& ranks)
{
  std::vector<char> isMarked = MarkOwnNodes(mesh, isCut);
  const bool isPeriodic = ranks.Any(mesh.PeriodicPartner != nullptr);
  std::vector<Index> points;
  std::vector<std::array<Index, 1>> classes;
  std::vector<char> marks;
  for (Index point = 0; point < mesh.NumberOfPoints; ++point)
  {
    if (isPeriodic || isMarked[point] != 0 || mesh.GeometryDimension[point] < DimensionInside(mesh))
    {
      points.push_back(point);
      classes.push_back({ { ClassesOf(mesh)[point] } });
      marks.push_back(isMarked[point]);
    }
  }
  marks = MergeByKey(
    classes, marks, [](char a, char b) { return std::max(a, b); }, ranks);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    isMarked[points[i]] = marks[i];
  }
  return isMarked;
}

/// Returns the corners at marked points, by point and element.
std::vector<Corner> ListCorners(const MeshData& mesh, const std::vector<char>& isMarked)
{
  std::vector<Corner> corners;
  for (Index place = 0; place < mesh.Corners * mesh.NumberOfElements; ++place)
  {
    if (isMarked[mesh.Elements[place]] != 0)
    {
      corners.push_back({ mesh.Elements[place], place / mesh.Corners, place });
    }
  }
  std::sort(corners.begin(), corners.end(),
    [](const Corner& a, const Corner& b)
    { return std::tie(a.Node, a.Place) < std::tie(b.Node, b.Place); });
  return corners;
}

/// Connects the corners at each node by uncut faces.
class CornerGroups
{
public:
  CornerGroups(
    const MeshData& mesh, const std::vector<char>& isCut, const std::vector<Corner>& corners) :
    TheMesh(mesh), IsCut(isCut), Corners(corners), Sets(MakeSets(corners.size()))
  {
    const std::vector<ElementSide> sides = this->ListSides();
    ForEqualFaces(
      sides.size(), [&](Index s) { return SortedPointsOfSide(mesh, sides[s]); },
      [&](std::span<const NumberedFace> same)
      {
        for (std::size_t f = 0; f < same.size(); f += 2)
        {
          this->Connect(same[f].Points, sides[same[f].Number].Element,
            f + 1 < same.size() ? sides[same[f + 1].Number].Element : -1);
        }
      });
  }

  /// Returns the lowest corner of the group of a corner.
  Index RootOf(Index corner) { return FindRoot(this->Sets, corner); }

  /// Faces with an element of this rank on one side only: sorted points, number of a corner.
  std::vector<NumberedFace> OpenFaces;

private:
  /// Returns whether a face connects elements, or may connect elements of different ranks or sides.
  bool Connects(const ElementSide& side) const
  {
    const std::vector<MeshFacet>& facets = *this->TheMesh.Facets;
    const auto found = std::lower_bound(facets.begin(), facets.end(), side);
    if (found == facets.end() || ElementSide(*found) != side)
    {
      return true;
    }
    return this->IsCut[found - facets.begin()] == 0 &&
      (found->Behind != NothingBehind || this->TheMesh.PeriodicPartner);
  }

  /// Returns the sides at the corners that connect elements.
  std::vector<ElementSide> ListSides() const
  {
    std::vector<ElementSide> sides;
    for (const Corner& corner : this->Corners)
    {
      for (int side = 0; side < SidesOf(this->TheMesh); ++side)
      {
        const FaceIds points = PointsOfSide(this->TheMesh, { corner.Element, side });
        const bool isAtNode = std::find(points.begin(), points.end(), corner.Node) != points.end();
        if (isAtNode && this->Connects({ corner.Element, side }))
        {
          sides.push_back({ corner.Element, side });
        }
      }
    }
    SortUnique(sides);
    return sides;
  }

  /// Returns the corner of an element at a point, or -1.
  Index FindCorner(Index element, Index point) const
  {
    const auto found =
      std::lower_bound(this->Corners.begin(), this->Corners.end(), std::tie(point, element),
        [](const Corner& corner, const auto& key)
        { return std::tie(corner.Node, corner.Element) < key; });
    const bool isFound =
      found != this->Corners.end() && found->Node == point && found->Element == element;
    return isFound ? found - this->Corners.begin() : -1;
  }

  /// Connects the corners of two elements at their common face.
  /// @param second  second element, or -1: the face is open
  void Connect(const FaceIds& points, Index first, Index second)
  {
    for (Index point : points)
    {
      const Index corner = point < 0 ? -1 : this->FindCorner(first, point);
      if (corner >= 0 && second >= 0)
      {
        Join(this->Sets, corner, this->FindCorner(second, point));
      }
      else if (corner >= 0)
      {
        this->OpenFaces.push_back({ points, corner });
      }
    }
  }

  const MeshData& TheMesh;
  const std::vector<char>& IsCut;
  const std::vector<Corner>& Corners;
  std::vector<Index> Sets;
};

/// Returns the group of each part: the lowest one of the parts that open faces connect.
/// @param parts  ascending
std::vector<Index> ConnectParts(const std::vector<Part>& parts, std::vector<PartLink> links)
{
  const auto keyOf = [](const PartLink& link) { return std::tie(link.Of.Class, link.Face); };
  std::sort(links.begin(), links.end(),
    [&](const PartLink& a, const PartLink& b) { return keyOf(a) < keyOf(b); });
  std::vector<Index> sets = MakeSets(parts.size());
  for (std::size_t l = 1; l < links.size(); ++l)
  {
    if (keyOf(links[l - 1]) == keyOf(links[l]))
    {
      Join(sets, FindSorted(parts, links[l - 1].Of), FindSorted(parts, links[l].Of));
    }
  }
  for (std::size_t p = 0; p < sets.size(); ++p)
  {
    sets[p] = FindRoot(sets, static_cast<Index>(p));
  }
  return sets;
}

/// A group of elements at a node: the node and the lowest element of the group.
using GroupKey = std::array<Index, 2>;

/// Returns the id of the copy of each group.
/// @param keys  of all groups whose nodes this rank knows, ascending
/// @param first  first new id
/// @pre Collective
std::vector<Index> NumberGroups(const std::vector<GroupKey>& keys, Index first, Ranks& ranks)
{
  std::vector<GroupKey> added;
  std::vector<Index> ids;
  for (std::size_t k = 0; k < keys.size(); ++k)
  {
    const bool isFirst = k == 0 || keys[k - 1][0] != keys[k][0];
    ids.push_back(isFirst ? keys[k][0] : 0);
    if (!isFirst)
    {
      added.push_back(keys[k]);
    }
  }
  const std::vector<std::int64_t> numbers = NumberItems(added, FirstOfKey(), ranks).Numbers;
  auto number = numbers.begin();
  for (Index& id : ids)
  {
    id = id == 0 ? first + *number++ : id;
  }
  return ids;
}

/// Returns the copies for parts with all parts of their nodes.
/// @param parts  ascending
/// @pre Collective
std::vector<PartCopy> NumberParts(
  const std::vector<Part>& parts, const std::vector<PartLink>& links, Index first, Ranks& ranks)
{
  const std::vector<Index> groups = ConnectParts(parts, links);
  std::vector<Index> lowest(parts.size(), std::numeric_limits<Index>::max());
  for (std::size_t p = 0; p < parts.size(); ++p)
  {
    lowest[groups[p]] = std::min(lowest[groups[p]], parts[p].Element);
  }
  std::vector<GroupKey> keys;
  for (std::size_t p = 0; p < parts.size(); ++p)
  {
    keys.push_back({ { parts[p].Node, lowest[groups[p]] } });
  }
  std::vector<GroupKey> distinct = keys;
  SortUnique(distinct);
  const std::vector<Index> ids = NumberGroups(distinct, first, ranks);
  std::vector<PartCopy> copies;
  std::vector<Index> partners(parts.size(), std::numeric_limits<Index>::max());
  for (std::size_t p = 0; p < parts.size(); ++p)
  {
    copies.push_back({ ids[FindSorted(distinct, keys[p])], 0 });
    partners[groups[p]] = std::min(partners[groups[p]], copies[p].Id);
  }
  for (std::size_t p = 0; p < parts.size(); ++p)
  {
    copies[p].Partner = partners[groups[p]];
  }
  return copies;
}

/// Returns the copies of parts, from the ranks that number them.
/// @pre Collective
std::vector<PartCopy> AskForCopies(
  const std::vector<Part>& parts, const std::vector<PartLink>& links, Index first, Ranks& ranks)
{
  const auto rankOf = [&ranks](const Part& part)
  { return MeetingRank(std::array<Index, 1>{ { part.Class } }, ranks.Count()); };
  const std::vector<PartLink> received = SendItems(
    links, [&rankOf](const PartLink& link) { return rankOf(link.Of); }, ranks);
  const auto answer = [&](const std::vector<Part>& asked)
  {
    std::vector<Part> sorted = asked;
    SortUnique(sorted);
    const std::vector<PartCopy> copies = NumberParts(sorted, received, first, ranks);
    std::vector<PartCopy> answers;
    for (const Part& part : asked)
    {
      answers.push_back(copies[FindSorted(sorted, part)]);
    }
    return answers;
  };
  return AskRanks(parts, rankOf, answer, ranks);
}

} // namespace

std::vector<CornerCopy> FindNodeCopies(
  const MeshData& mesh, const std::vector<char>& isCut, Ranks& ranks)
{
  const std::vector<Corner> corners = ListCorners(mesh, MarkNodes(mesh, isCut, ranks));
  CornerGroups groups(mesh, isCut, corners);
  std::vector<Part> parts;
  std::vector<Index> partOf(corners.size());
  for (std::size_t c = 0; c < corners.size(); ++c)
  {
    const Corner& corner = corners[c];
    const Index root = groups.RootOf(static_cast<Index>(c));
    partOf[c] = partOf[root];
    if (root == static_cast<Index>(c))
    {
      partOf[c] = static_cast<Index>(parts.size());
      parts.push_back({ ClassesOf(mesh)[corner.Node], mesh.PointIds[corner.Node],
        mesh.ElementIds[corner.Element] });
    }
  }
  std::vector<PartLink> links;
  for (const NumberedFace& face : groups.OpenFaces)
  {
    links.push_back({ parts[partOf[face.Number]], SortedIds(face.Points, ClassesOf(mesh)) });
  }
  const Index* ids = mesh.PointIds;
  const Index first = FindGreatestId(ids, ids + mesh.NumberOfPoints, ranks) + 1;
  const std::vector<PartCopy> answers = AskForCopies(parts, links, first, ranks);
  std::vector<CornerCopy> copies;
  for (std::size_t c = 0; c < corners.size(); ++c)
  {
    const PartCopy& copy = answers[partOf[c]];
    copies.push_back({ corners[c].Place, copy.Id, copy.Partner });
  }
  return copies;
}

} // namespace vfm
