#include "Report/MatchFaces.h"

#include "Elements/EqualFaces.h"
#include "Ranks/AskRanks.h"
#include "Ranks/MeetingRank.h"
#include "Ranks/WorkTogether.h"

namespace vfm
{
namespace
{

/// @param ids  ids of the points, separated by commas
[[noreturn]] void RejectFace(const std::string& ids)
{
  throw InputError("The mesh is not conforming: the face of the points " + ids +
    " belongs to more than two elements.");
}

std::string ListIds(const MeshData& mesh, const FaceIds& points)
{
  std::string ids;
  for (Index point : points)
  {
    const Index id = point < 0 || !mesh.PointIds ? point : mesh.PointIds[point];
    ids += point < 0 ? "" : (ids.empty() ? "" : ", ") + std::to_string(id);
  }
  return ids;
}

/// Returns the number of the partner of each face in the list, or NothingBehind.
std::vector<Index> MatchList(const std::vector<NumberedFace>& faces)
{
  std::vector<Index> behind(faces.size(), NothingBehind);
  ForEqualFaces(
    faces.size(), [&faces](Index f) { return faces[f].Points; },
    [&](std::span<const NumberedFace> same)
    {
      if (same.size() > 2)
      {
        const FaceIds& ids = same[0].Points;
        RejectFace(
          std::to_string(ids[1]) + ", " + std::to_string(ids[2]) + ", " + std::to_string(ids[3]));
      }
      if (same.size() == 2)
      {
        behind[same[0].Number] = faces[same[1].Number].Number;
        behind[same[1].Number] = faces[same[0].Number].Number;
      }
    });
  return behind;
}

} // namespace

FaceIds PointsOfSide(const MeshData& mesh, const ElementSide& side)
{
  return ElementFaces(mesh.Corners).PointsOf(mesh.Element(side.Element), side.Side);
}

FaceIds SortedPointsOfSide(const MeshData& mesh, const ElementSide& side)
{
  FaceIds points = PointsOfSide(mesh, side);
  std::sort(points.begin(), points.end());
  return points;
}

FaceIds SortedIds(const FaceIds& points, const Index* ids)
{
  FaceIds found;
  std::transform(points.begin(), points.end(), found.begin(),
    [ids](Index point) { return point < 0 ? point : ids[point]; });
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<Index> MatchSides(const MeshData& mesh)
{
  const int sides = ElementFaces(mesh.Corners).Count;
  std::vector<Index> behind(sides * mesh.NumberOfElements, NothingBehind);
  ForEqualFaces(
    behind.size(),
    [&](Index number) {
      return SortedPointsOfSide(mesh, { number / sides, static_cast<int>(number % sides) });
    },
    [&](std::span<const NumberedFace> same)
    {
      if (same.size() > 2)
      {
        RejectFace(ListIds(mesh, same[0].Points));
      }
      if (same.size() == 2)
      {
        behind[same[0].Number] = same[1].Number / sides;
        behind[same[1].Number] = same[0].Number / sides;
      }
    });
  return behind;
}

std::vector<Index> MatchFaces(
  const std::vector<FaceIds>& ids, const std::vector<Index>& values, Ranks& ranks)
{
  std::vector<NumberedFace> faces;
  for (std::size_t f = 0; f < ids.size(); ++f)
  {
    faces.push_back({ ids[f], values[f] });
  }
  std::vector<Index> behind;
  WorkTogether(ranks, [&] { behind = MatchList(faces); });
  if (ranks.Count() == 1)
  {
    return behind;
  }
  std::vector<std::size_t> open;
  std::vector<NumberedFace> questions;
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    if (behind[f] == NothingBehind)
    {
      open.push_back(f);
      questions.push_back(faces[f]);
    }
  }
  const auto rankOf = [&ranks](const NumberedFace& face)
  { return MeetingRank(face.Points, ranks.Count()); };
  const auto answer = [&ranks](const std::vector<NumberedFace>& received)
  {
    std::vector<Index> answers;
    WorkTogether(ranks, [&] { answers = MatchList(received); });
    return answers;
  };
  const std::vector<Index> answers = AskRanks(questions, rankOf, answer, ranks);
  for (std::size_t q = 0; q < open.size(); ++q)
  {
    behind[open[q]] = answers[q];
  }
  return behind;
}

} // namespace vfm
