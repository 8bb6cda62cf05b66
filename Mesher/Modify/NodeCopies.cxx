#include "Modify/NodeCopies.h"

#include "Base/DisjointSets.h"
#include "Base/Sorted.h"
#include "Elements/ElementFaces.h"
#include "Modify/GreatestId.h"
#include "Ranks/MeetingRank.h"
#include "Ranks/MergeByKey.h"
#include "Ranks/NumberInOrder.h"
#include "Report/MatchFaces.h"

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

/// Elements of this rank at a node that are connected by faces of this rank.
struct Part
{
  Index Class;   // PeriodicPartner of the node, or its id
  Index Node;    // global id
  Index Element; // lowest global id
};

/// A face of a part behind which an element of another rank or of the opposite side may be.
struct OpenFace
{
  Index Part;
  FaceIds Ids; // sorted classes of its nodes
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

/// Returns the rank that numbers the copies of a node.
int RankOf(Index nodeClass, Ranks& ranks)
{
  return MeetingRank(std::array<Index, 1>{ { nodeClass } }, ranks.Count());
}

std::vector<char> MarkOwnNodes(const MeshData& mesh, const std::vector<char>& isCut)
{
  const ElementFaces faces(mesh.Corners);
  std::vector<char> isMarked(mesh.NumberOfPoints, 0);
  for (std::size_t f = 0; f < isCut.size(); ++f)
  {
    const MeshFacet& facet = (*mesh.Facets)[f];
    for (Index point : faces.PointsOf(mesh.Element(facet.Element), facet.Side))
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
    if (isPeriodic || isMarked[point] != 0 || mesh.GeometryDimension[point] < DimensionOfVolumes)
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
    ForRuns(
      corners.begin(), corners.end(),
      [](const Corner& a, const Corner& b) { return a.Node == b.Node; },
      [&](auto begin, auto end)
      { this->ConnectAtNode(begin - corners.begin(), end - corners.begin()); });
  }

  /// Returns the lowest corner of the group of a corner.
  Index RootOf(Index corner) { return FindRoot(this->Sets, corner); }

  struct Face
  {
    FaceIds Points; // sorted points of the mesh
    Index Corner;
    bool operator<(const Face& other) const { return this->Points < other.Points; }
  };
  std::vector<Face> OpenFaces; ///< faces with an element of this rank on one side only

private:
  /// Returns whether a face connects elements, or may connect elements of different ranks or sides.
  bool Connects(Index element, int side) const
  {
    const std::vector<MeshFacet>& facets = *this->TheMesh.Facets;
    const auto found = std::lower_bound(facets.begin(), facets.end(), std::tie(element, side),
      [](const MeshFacet& facet, const auto& key)
      { return std::tie(facet.Element, facet.Side) < key; });
    if (found == facets.end() || found->Element != element || found->Side != side)
    {
      return true;
    }
    return this->IsCut[found - facets.begin()] == 0 &&
      (found->Behind != NothingBehind || this->TheMesh.PeriodicPartner);
  }

  void ConnectAtNode(Index begin, Index end)
  {
    const ElementFaces table(this->TheMesh.Corners);
    std::vector<Face> faces;
    for (Index c = begin; c < end; ++c)
    {
      const Corner& corner = this->Corners[c];
      for (int side = 0; side < table.Count; ++side)
      {
        FaceIds points = table.PointsOf(this->TheMesh.Element(corner.Element), side);
        const bool isAtNode = std::find(points.begin(), points.end(), corner.Node) != points.end();
        if (isAtNode && this->Connects(corner.Element, side))
        {
          std::sort(points.begin(), points.end());
          faces.push_back({ points, c });
        }
      }
    }
    std::sort(faces.begin(), faces.end());
    for (std::size_t f = 0; f < faces.size(); ++f)
    {
      if (f + 1 < faces.size() && faces[f].Points == faces[f + 1].Points)
      {
        Join(this->Sets, faces[f].Corner, faces[f + 1].Corner);
        ++f;
      }
      else
      {
        this->OpenFaces.push_back(faces[f]);
      }
    }
  }

  const MeshData& TheMesh;
  const std::vector<char>& IsCut;
  const std::vector<Corner>& Corners;
  std::vector<Index> Sets;
};

/// Returns the group of each part: the lowest one of the parts that open faces connect.
std::vector<Index> ConnectParts(const std::vector<Part>& parts, std::vector<OpenFace> faces)
{
  std::vector<Index> sets = MakeSets(parts.size());
  const auto keyOf = [&parts](const OpenFace& face)
  { return std::make_tuple(parts[face.Part].Class, face.Ids); };
  std::sort(faces.begin(), faces.end(),
    [&](const OpenFace& a, const OpenFace& b) { return keyOf(a) < keyOf(b); });
  for (std::size_t f = 1; f < faces.size(); ++f)
  {
    if (keyOf(faces[f - 1]) == keyOf(faces[f]))
    {
      Join(sets, faces[f - 1].Part, faces[f].Part);
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
  const std::vector<std::int64_t> numbers = NumberInOrder(added, ranks);
  auto number = numbers.begin();
  for (Index& id : ids)
  {
    id = id == 0 ? first + *number++ : id;
  }
  return ids;
}

/// Returns the copies for parts with all parts of their nodes.
/// @pre Collective
std::vector<PartCopy> NumberParts(
  const std::vector<Part>& parts, const std::vector<OpenFace>& faces, Index first, Ranks& ranks)
{
  const std::vector<Index> groups = ConnectParts(parts, faces);
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

/// Parts and open faces for the ranks that number them.
struct Questions
{
  std::vector<std::vector<Part>> Parts;
  std::vector<std::vector<OpenFace>> Faces; // OpenFace::Part: index in Parts
};

/// Returns the copies of the parts in the questions of all ranks to this rank.
/// @pre Collective
std::vector<std::vector<PartCopy>> AnswerParts(
  const Questions& questions, Index first, Ranks& ranks)
{
  const std::vector<Bytes> parts = ExchangeAll(PackLists(questions.Parts), ranks);
  const std::vector<Bytes> faces = ExchangeAll(PackLists(questions.Faces), ranks);
  std::vector<OpenFace> allFaces;
  std::vector<Index> ends{ 0 };
  for (std::size_t rank = 0; rank < parts.size(); ++rank)
  {
    for (OpenFace face : FromBytes<OpenFace>(faces[rank]))
    {
      face.Part += ends.back();
      allFaces.push_back(face);
    }
    ends.push_back(ends.back() + static_cast<Index>(parts[rank].size() / sizeof(Part)));
  }
  const std::vector<PartCopy> copies = NumberParts(JoinItems<Part>(parts), allFaces, first, ranks);
  std::vector<std::vector<PartCopy>> lists;
  for (std::size_t rank = 0; rank < parts.size(); ++rank)
  {
    lists.emplace_back(copies.begin() + ends[rank], copies.begin() + ends[rank + 1]);
  }
  std::vector<std::vector<PartCopy>> answers;
  for (const Bytes& message : ExchangeAll(PackLists(lists), ranks))
  {
    answers.push_back(FromBytes<PartCopy>(message));
  }
  return answers;
}

} // namespace

std::vector<CornerCopy> FindNodeCopies(
  const MeshData& mesh, const std::vector<char>& isCut, Ranks& ranks)
{
  const std::vector<Corner> corners = ListCorners(mesh, MarkNodes(mesh, isCut, ranks));
  CornerGroups groups(mesh, isCut, corners);
  Questions questions{ std::vector<std::vector<Part>>(ranks.Count()),
    std::vector<std::vector<OpenFace>>(ranks.Count()) };
  std::vector<Index> partOf(corners.size()); // index of the part of a corner in its question
  for (std::size_t c = 0; c < corners.size(); ++c)
  {
    const Corner& corner = corners[c];
    const Index root = groups.RootOf(static_cast<Index>(c));
    const Index nodeClass = ClassesOf(mesh)[corner.Node];
    std::vector<Part>& parts = questions.Parts[RankOf(nodeClass, ranks)];
    partOf[c] = partOf[root];
    if (root == static_cast<Index>(c))
    {
      partOf[c] = static_cast<Index>(parts.size());
      parts.push_back({ nodeClass, mesh.PointIds[corner.Node], mesh.ElementIds[corner.Element] });
    }
  }
  for (const CornerGroups::Face& face : groups.OpenFaces)
  {
    const Index nodeClass = ClassesOf(mesh)[corners[face.Corner].Node];
    questions.Faces[RankOf(nodeClass, ranks)].push_back(
      { partOf[face.Corner], SortedIds(face.Points, ClassesOf(mesh)) });
  }
  const Index* ids = mesh.PointIds;
  const Index first = FindGreatestId(ids, ids + mesh.NumberOfPoints, ranks) + 1;
  const std::vector<std::vector<PartCopy>> answers = AnswerParts(questions, first, ranks);
  std::vector<CornerCopy> copies;
  for (std::size_t c = 0; c < corners.size(); ++c)
  {
    const int rank = RankOf(ClassesOf(mesh)[corners[c].Node], ranks);
    const PartCopy& copy = answers[rank][partOf[c]];
    copies.push_back({ corners[c].Place, copy.Id, copy.Partner });
  }
  return copies;
}

} // namespace vfm
