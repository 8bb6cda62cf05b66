#include "Report/MatchFaces.h"

#include "Ranks/Agreement.h"
#include "Ranks/ExchangeAll.h"
#include "Ranks/MeetingRank.h"

#include <algorithm>
#include <numeric>

namespace vfm
{
namespace
{

struct Face
{
  FaceIds Ids;
  Index Value;
};

/// Returns the value of the partner of each face in the list.
std::vector<Index> MatchHere(const std::vector<Face>& faces)
{
  std::vector<Index> order(faces.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(
    order.begin(), order.end(), [&faces](Index a, Index b) { return faces[a].Ids < faces[b].Ids; });
  std::vector<Index> behind(faces.size(), NothingBehind);
  for (std::size_t i = 0; i + 1 < order.size(); ++i)
  {
    const Face &face = faces[order[i]], &next = faces[order[i + 1]];
    if (face.Ids != next.Ids)
    {
      continue;
    }
    if (behind[order[i]] != NothingBehind)
    {
      throw InputError("The mesh is not conforming: the face of the points " +
        std::to_string(face.Ids[1]) + ", " + std::to_string(face.Ids[2]) + ", " +
        std::to_string(face.Ids[3]) + " belongs to more than two elements.");
    }
    behind[order[i]] = next.Value;
    behind[order[i + 1]] = face.Value;
  }
  return behind;
}

/// Returns the values behind the faces that each rank sent.
std::vector<Bytes> Answer(const std::vector<Bytes>& questions)
{
  std::vector<Face> faces;
  std::vector<std::size_t> ends;
  for (const Bytes& question : questions)
  {
    const std::vector<Face> some = FromBytes<Face>(question);
    faces.insert(faces.end(), some.begin(), some.end());
    ends.push_back(faces.size());
  }
  const std::vector<Index> behind = MatchHere(faces);
  std::vector<Bytes> answers;
  std::size_t begin = 0;
  for (std::size_t end : ends)
  {
    answers.push_back(ToBytes(std::vector<Index>(behind.begin() + begin, behind.begin() + end)));
    begin = end;
  }
  return answers;
}

} // namespace

FaceIds SortedIds(const FaceIds& points, const Index* ids)
{
  FaceIds found;
  std::transform(points.begin(), points.end(), found.begin(),
    [ids](Index point) { return point < 0 ? point : ids[point]; });
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<Index> MatchFaces(
  const std::vector<FaceIds>& ids, const std::vector<Index>& values, Ranks& ranks)
{
  std::vector<Face> faces;
  for (std::size_t f = 0; f < ids.size(); ++f)
  {
    faces.push_back({ ids[f], values[f] });
  }
  std::vector<Index> behind;
  WorkTogether(ranks, [&] { behind = MatchHere(faces); });
  if (ranks.Count() == 1)
  {
    return behind;
  }
  std::vector<std::vector<Face>> open(ranks.Count()); // unmatched faces of each matching rank
  std::vector<std::vector<std::size_t>> places(ranks.Count());
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    if (behind[f] == NothingBehind)
    {
      const int rank = MeetingRank(faces[f].Ids, ranks.Count());
      open[rank].push_back(faces[f]);
      places[rank].push_back(f);
    }
  }
  std::vector<Bytes> messages = ExchangeAll(PackLists(open), ranks);
  WorkTogether(ranks, [&messages] { messages = Answer(messages); });
  messages = ExchangeAll(std::move(messages), ranks);
  for (int rank = 0; rank < ranks.Count(); ++rank)
  {
    const std::vector<Index> answers = FromBytes<Index>(messages[rank]);
    for (std::size_t i = 0; i < answers.size(); ++i)
    {
      behind[places[rank][i]] = answers[i];
    }
  }
  return behind;
}

} // namespace vfm
