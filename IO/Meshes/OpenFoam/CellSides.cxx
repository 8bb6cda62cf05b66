#include "Meshes/OpenFoam/CellSides.h"

#include "Ranks/WorkTogether.h"
#include "Report/MatchFaces.h"

#include <numeric>

namespace vfm
{
namespace
{

/// A side with its points in ascending order.
struct Face
{
  FaceIds Points;
  Index Side;
  bool operator<(const Face& other) const { return this->Points < other.Points; }
};

Index LowestPoint(const FaceIds& sorted)
{
  return sorted[0] < 0 ? sorted[1] : sorted[0];
}

Index CountSides(const MeshData& mesh)
{
  return ElementFaces(mesh.Corners).Count * mesh.NumberOfElements;
}

/// Returns all sides ordered by their lowest point.
/// @param[out] ends  end of the list of each point
std::vector<Index> SortByLowestPoint(const MeshData& mesh, std::vector<Index>& ends)
{
  const Index count = CountSides(mesh);
  ends.assign(static_cast<std::size_t>(mesh.NumberOfPoints) + 1, 0);
  for (Index side = 0; side < count; ++side)
  {
    ++ends[LowestPoint(SortedPointsOfSide(mesh, side)) + 1];
  }
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  std::vector<Index> sides(static_cast<std::size_t>(count));
  for (Index side = 0; side < count; ++side)
  {
    sides[ends[LowestPoint(SortedPointsOfSide(mesh, side))]++] = side;
  }
  return sides;
}

[[noreturn]] void RejectFace(const MeshData& mesh, const Face& face)
{
  std::string ids;
  for (Index point : face.Points)
  {
    ids += point < 0 ? "" : (ids.empty() ? "" : ", ") + std::to_string(mesh.PointIds[point]);
  }
  throw InputError("The mesh is not conforming: the face of the points " + ids +
    " belongs to more than two elements.");
}

/// Sets the cells behind the sides in a list, which are all sides of this rank with their lowest
/// point.
void MatchAtPoint(const MeshData& mesh, std::vector<Face>& faces, std::vector<Index>& behind)
{
  const Index sides = ElementFaces(mesh.Corners).Count;
  std::sort(faces.begin(), faces.end());
  for (std::size_t f = 1; f < faces.size(); ++f)
  {
    const Face &last = faces[f - 1], &face = faces[f];
    if (last.Points == face.Points)
    {
      if (behind[last.Side] != NothingBehind)
      {
        RejectFace(mesh, face);
      }
      behind[last.Side] = face.Side / sides;
      behind[face.Side] = last.Side / sides;
    }
  }
}

/// Returns the cells of this rank behind its sides.
std::vector<Index> MatchHere(const MeshData& mesh)
{
  std::vector<Index> ends;
  const std::vector<Index> sides = SortByLowestPoint(mesh, ends);
  std::vector<Index> behind(sides.size(), NothingBehind);
  std::vector<Face> faces;
  Index begin = 0;
  for (Index point = 0; point < mesh.NumberOfPoints; ++point)
  {
    faces.clear();
    for (; begin < ends[point]; ++begin)
    {
      faces.push_back({ SortedPointsOfSide(mesh, sides[begin]), sides[begin] });
    }
    MatchAtPoint(mesh, faces, behind);
  }
  return behind;
}

/// Finds the cells of other ranks behind the open sides.
/// @pre Collective
void MatchRemote(
  const MeshData& mesh, const std::vector<Index>& positions, CellSides& cells, Ranks& ranks)
{
  const Index sides = ElementFaces(mesh.Corners).Count;
  std::vector<Index> open, values; // a value is the position of the cell and the rank
  std::vector<FaceIds> ids;
  for (Index side = 0; side < static_cast<Index>(cells.Behind.size()); ++side)
  {
    if (cells.Behind[side] == NothingBehind)
    {
      open.push_back(side);
      values.push_back(positions[side / sides] * ranks.Count() + ranks.Rank());
      ids.push_back(SortedPointsOfSide(mesh, side));
      for (Index& point : ids.back())
      {
        point = point < 0 ? point : mesh.PointIds[point];
      }
    }
  }
  const std::vector<Index> behind = MatchFaces(ids, values, ranks);
  for (std::size_t f = 0; f < open.size(); ++f)
  {
    if (behind[f] != NothingBehind)
    {
      cells.Behind[open[f]] = RemoteBehind;
      cells.Remote.push_back(
        { open[f], behind[f] / ranks.Count(), static_cast<int>(behind[f] % ranks.Count()) });
    }
  }
}

} // namespace

FaceIds PointsOfSide(const MeshData& mesh, Index side)
{
  const ElementFaces table(mesh.Corners);
  FaceIds points =
    table.PointsOf(mesh.Element(side / table.Count), static_cast<int>(side % table.Count));
  const auto end = points.begin() + table.Corners;
  const auto key = [&mesh](Index point)
  { return mesh.PeriodicPartner ? mesh.PeriodicPartner[point] : point; };
  const auto first =
    std::min_element(points.begin(), end, [&key](Index a, Index b) { return key(a) < key(b); });
  std::rotate(points.begin(), first, end);
  return points;
}

FaceIds SortedPointsOfSide(const MeshData& mesh, Index side)
{
  const ElementFaces table(mesh.Corners);
  FaceIds points =
    table.PointsOf(mesh.Element(side / table.Count), static_cast<int>(side % table.Count));
  std::sort(points.begin(), points.end());
  return points;
}

CellSides FindCellSides(const MeshData& mesh, const std::vector<Index>& positions, Ranks& ranks)
{
  CellSides cells;
  WorkTogether(ranks,
    [&]
    {
      cells.Behind = MatchHere(mesh);
      if (ranks.Count() > 1)
      {
        MatchRemote(mesh, positions, cells, ranks);
      }
    });
  return cells;
}

} // namespace vfm
