#include "Report/Fragments/FragmentPairs.h"

#include "Elements/EqualFaces.h"
#include "Ranks/AskRanks.h"
#include "Ranks/MeetingRank.h"
#include "Ranks/WorkTogether.h"
#include "Report/FlatData.h"
#include "Report/MatchFaces.h"

#include <limits>

namespace vfm
{
namespace
{

/// Faces of elements as numbers, which take a quarter of the memory of their points.
class FaceNumbers
{
public:
  explicit FaceNumbers(const MeshData& mesh) :
    TheMesh(mesh),
    Ids(mesh.PeriodicPartner && !mesh.OriginalPointIds ? mesh.PeriodicPartner
                                                       : mesh.UnsplitPointIds())
  {
  }

  /// Lists the faces that can be on a surface. Points on periodic sides count as inside a volume.
  std::vector<Index> List() const
  {
    const MeshData& mesh = this->TheMesh;
    const int sides = SidesOf(mesh), inside = DimensionInside(mesh);
    const int* dimensions = mesh.PeriodicPartner ? nullptr : mesh.GeometryDimension;
    const auto isInside = [dimensions, inside](Index point)
    { return point >= 0 && dimensions && dimensions[point] >= inside; };
    std::vector<Index> faces;
    for (Index element = 0; element < mesh.NumberOfElements; ++element)
    {
      for (int side = 0; side < sides; ++side)
      {
        const FaceIds points = PointsOfSide(mesh, { element, side });
        if (std::none_of(points.begin(), points.end(), isInside))
        {
          faces.push_back(Sides * element + side);
        }
      }
    }
    return faces;
  }

  int FragmentOf(Index face) const { return this->TheMesh.Fragment[face / Sides]; }
  /// Returns the global ids of the points of a face, ascending.
  FaceIds PointsOf(Index face) const
  {
    return SortedIds(
      PointsOfSide(this->TheMesh, { face / Sides, static_cast<int>(face % Sides) }), this->Ids);
  }

private:
  static constexpr Index Sides = 8;
  const MeshData& TheMesh;
  const Index* Ids;
};

void AddPair(int own, Index behind, std::vector<FragmentPair>& pairs)
{
  if (behind != NothingBehind && behind != own)
  {
    pairs.push_back({ { own, static_cast<int>(behind) } });
  }
}

/// Adds the pairs of fragments between elements of this rank.
/// @return the other faces, and those that belong to more than two elements
std::vector<Index> MatchOnRank(const FaceNumbers& numbers, std::vector<FragmentPair>& pairs)
{
  const std::vector<Index> faces = numbers.List();
  std::vector<Index> open;
  ForEqualFaces(
    faces.size(), [&](Index f) { return numbers.PointsOf(faces[f]); },
    [&](std::span<const NumberedFace> same)
    {
      if (same.size() == 2)
      {
        const int first = numbers.FragmentOf(faces[same[0].Number]),
                  second = numbers.FragmentOf(faces[same[1].Number]);
        AddPair(first, second, pairs);
        AddPair(second, first, pairs);
        return;
      }
      for (const NumberedFace& face : same)
      {
        open.push_back(faces[face.Number]);
      }
    });
  return open;
}

/// Collective. Returns the faces that may also be on other ranks. Sends four bytes per face: nearly
/// all faces of most meshes are on one rank only.
std::vector<Index> KeepShared(
  const FaceNumbers& numbers, const std::vector<Index>& faces, Ranks& ranks)
{
  constexpr int hashes = std::numeric_limits<int>::max();
  std::vector<int> questions;
  questions.reserve(faces.size());
  for (Index face : faces)
  {
    questions.push_back(MeetingRank(numbers.PointsOf(face), hashes));
  }
  const auto rankOf = [&ranks](int hash) { return MeetingRank(hash, ranks.Count()); };
  const auto answer = [](const std::vector<int>& received)
  {
    std::vector<int> sorted = received;
    std::sort(sorted.begin(), sorted.end());
    std::vector<char> isTwice;
    isTwice.reserve(received.size());
    for (int hash : received)
    {
      const auto at = std::lower_bound(sorted.begin(), sorted.end(), hash) + 1;
      isTwice.push_back(at != sorted.end() && *at == hash);
    }
    return isTwice;
  };
  const std::vector<char> isTwice = AskRanks(questions, rankOf, answer, ranks);
  std::vector<Index> kept;
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    if (isTwice[f])
    {
      kept.push_back(faces[f]);
    }
  }
  return kept;
}

/// Collective. Adds the pairs of fragments between elements of this rank and of others.
void MatchBetweenRanks(const FaceNumbers& numbers, const std::vector<Index>& faces, Ranks& ranks,
  std::vector<FragmentPair>& pairs)
{
  std::vector<FaceIds> ids;
  std::vector<Index> fragments;
  for (Index face : faces)
  {
    ids.push_back(numbers.PointsOf(face));
    fragments.push_back(numbers.FragmentOf(face));
  }
  const std::vector<Index> behind = MatchFaces(ids, fragments, ranks);
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    AddPair(static_cast<int>(fragments[f]), behind[f], pairs);
  }
}

} // namespace

std::vector<FragmentPair> FindFragmentPairs(const MeshData& mesh, Ranks& ranks)
{
  const FaceNumbers numbers(mesh);
  std::vector<FragmentPair> pairs;
  std::vector<Index> open;
  WorkTogether(ranks,
    [&]
    {
      Require(mesh.PointIds, "GlobalPointIds", mesh);
      open = MatchOnRank(numbers, pairs);
    });
  if (ranks.Count() > 1)
  {
    open = KeepShared(numbers, open, ranks);
  }
  MatchBetweenRanks(numbers, open, ranks, pairs);
  SortUnique(pairs);
  return pairs;
}

} // namespace vfm
