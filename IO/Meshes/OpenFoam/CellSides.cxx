#include "Meshes/OpenFoam/CellSides.h"

#include "Ranks/WorkTogether.h"
#include "Report/FlatData.h"
#include "Report/MatchFaces.h"

namespace vfm
{
namespace
{

/// Finds the cells of other ranks behind the open sides.
/// @pre Collective
void MatchRemote(
  const MeshData& mesh, const std::vector<Index>& positions, CellSides& cells, Ranks& ranks)
{
  const Index sides = SidesOf(mesh);
  std::vector<Index> open, values; // a value is the position of the cell and the rank
  std::vector<FaceIds> ids;
  for (Index side = 0; side < static_cast<Index>(cells.Behind.size()); ++side)
  {
    if (cells.Behind[side] == NothingBehind)
    {
      open.push_back(side);
      values.push_back(positions[side / sides] * ranks.Count() + ranks.Rank());
      ids.push_back(SortedIds(PointsOfSide(mesh, side), mesh.PointIds));
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

ElementSide SideOfNumber(const MeshData& mesh, Index number)
{
  const Index sides = SidesOf(mesh);
  return { number / sides, static_cast<int>(number % sides) };
}

FaceIds PointsOfSide(const MeshData& mesh, Index number)
{
  FaceIds points = PointsOfSide(mesh, SideOfNumber(mesh, number));
  const auto end = points.begin() + CornersOfSide(mesh);
  const auto key = [&mesh](Index point)
  { return mesh.PeriodicPartner ? mesh.PeriodicPartner[point] : point; };
  const auto first =
    std::min_element(points.begin(), end, [&key](Index a, Index b) { return key(a) < key(b); });
  std::rotate(points.begin(), first, end);
  return points;
}

FaceIds SortedPointsOfSide(const MeshData& mesh, Index number)
{
  return SortedPointsOfSide(mesh, SideOfNumber(mesh, number));
}

CellSides FindCellSides(const MeshData& mesh, const std::vector<Index>& positions, Ranks& ranks)
{
  CellSides cells;
  WorkTogether(ranks,
    [&]
    {
      cells.Behind = MatchSides(mesh);
      if (ranks.Count() > 1)
      {
        MatchRemote(mesh, positions, cells, ranks);
      }
    });
  return cells;
}

} // namespace vfm
