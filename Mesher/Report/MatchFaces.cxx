#include "Report/MatchFaces.h"

#include "Elements/EqualFaces.h"
#include "Ranks/KeyMerge.h"
#include "Ranks/WorkTogether.h"
#include "Report/FlatData.h"

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

[[noreturn]] void RejectFace(const FaceIds& ids)
{
  RejectFace(
    std::to_string(ids[1]) + ", " + std::to_string(ids[2]) + ", " + std::to_string(ids[3]));
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

/// Returns the place of the partner of each face in the list, or NothingBehind.
std::vector<Index> MatchList(const std::vector<FaceIds>& faces)
{
  std::vector<Index> behind(faces.size(), NothingBehind);
  ForEqualFaces(
    faces.size(), [&faces](Index f) { return faces[f]; },
    [&](std::span<const NumberedFace> same)
    {
      if (same.size() > 2)
      {
        RejectFace(same[0].Points);
      }
      if (same.size() == 2)
      {
        behind[same[0].Number] = same[1].Number;
        behind[same[1].Number] = same[0].Number;
      }
    });
  return behind;
}

/// Faces without a partner on this rank, ascending by ids.
struct OpenFaces
{
  std::vector<FaceIds> Ids;
  std::vector<std::size_t> Places; ///< in the list of all faces
};

OpenFaces ListOpenFaces(const std::vector<FaceIds>& ids, const std::vector<Index>& behind)
{
  std::vector<FaceIds> open;
  std::vector<std::size_t> places;
  for (std::size_t f = 0; f < ids.size(); ++f)
  {
    if (behind[f] == NothingBehind)
    {
      open.push_back(ids[f]);
      places.push_back(f);
    }
  }
  OpenFaces sorted;
  for (std::size_t place : OrderOf(open))
  {
    sorted.Ids.push_back(open[place]);
    sorted.Places.push_back(places[place]);
  }
  return sorted;
}

/// Fills the values behind open faces from other ranks. Of two ranks with a face, each gets the sum
/// of the values of both, and subtracts its own.
/// @pre Collective
void MatchOverRanks(const OpenFaces& open, const std::vector<Index>& values, std::size_t width,
  Ranks& ranks, std::vector<Index>& found)
{
  std::vector<std::uint64_t> sums; // per face: number of ranks, and sum of each value
  for (std::size_t place : open.Places)
  {
    const auto own = values.begin() + static_cast<std::ptrdiff_t>(width * place);
    sums.push_back(1);
    sums.insert(sums.end(), own, own + static_cast<std::ptrdiff_t>(width));
  }
  KeyMerge<FaceIds>(open.Ids, ranks)
    .Merge(sums, 1 + width, [](std::uint64_t& a, std::uint64_t b) { a += b; });
  WorkTogether(ranks,
    [&]
    {
      for (std::size_t f = 0; f < open.Ids.size(); ++f)
      {
        const std::uint64_t* ofFace = sums.data() + (1 + width) * f;
        if (ofFace[0] > 2)
        {
          RejectFace(open.Ids[f]);
        }
        for (std::size_t i = 0; ofFace[0] == 2 && i < width; ++i)
        {
          const std::size_t at = width * open.Places[f] + i;
          found[at] = static_cast<Index>(ofFace[1 + i] - static_cast<std::uint64_t>(values[at]));
        }
      }
    });
}

} // namespace

FaceIds ValuesOfSide(const MeshData& mesh, const Index* ofCorners, int side)
{
  return IsFlat(mesh) ? FaceIds{ { ofCorners[side], ofCorners[(side + 1) % mesh.Corners], -1, -1 } }
                      : ElementFaces(mesh.Corners).PointsOf(ofCorners, side);
}

FaceIds PointsOfSide(const MeshData& mesh, const ElementSide& side)
{
  return ValuesOfSide(mesh, mesh.Element(side.Element), side.Side);
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
  const int sides = SidesOf(mesh);
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

std::vector<Index> MatchFaces(const std::vector<FaceIds>& ids, const std::vector<Index>& values,
  Ranks& ranks, std::size_t width)
{
  std::vector<Index> behind;
  WorkTogether(ranks, [&] { behind = MatchList(ids); });
  std::vector<Index> found(values.size(), NothingBehind);
  for (std::size_t f = 0; f < behind.size(); ++f)
  {
    if (behind[f] != NothingBehind)
    {
      const auto other = values.begin() + static_cast<std::ptrdiff_t>(width * behind[f]);
      std::copy_n(other, width, found.begin() + static_cast<std::ptrdiff_t>(width * f));
    }
  }
  if (ranks.Count() > 1)
  {
    MatchOverRanks(ListOpenFaces(ids, behind), values, width, ranks, found);
  }
  return found;
}

} // namespace vfm
