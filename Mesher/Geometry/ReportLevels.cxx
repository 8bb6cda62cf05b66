#include "Geometry/ReportLevels.h"

#include "Elements/Tet/TetTopology.h"
#include "Octree/LevelIds.h"

namespace vfm
{
namespace
{

/// Returns the number of whole cells of each level, then of transition hexes. In a mesh of tets, of
/// cells whose centres are points, then of those that touch finer cells.
std::vector<std::int64_t> CountHexes(const Mesh& mesh)
{
  const RefinedGrid& levels = *mesh.Levels;
  const int refinements = levels.NumberOfRefinements();
  std::vector<std::int64_t> hexes(refinements + 2, 0);
  const auto countCoarse = [&](const OctreeKeys::LevelIndex& cell)
  {
    const bool isWhole = !levels.Families().IsTouched(cell.Level, cell.At);
    ++hexes[isWhole ? cell.Level : refinements + 1];
  };
  if (mesh.HasHexes())
  {
    for (Index id : mesh.ElementIds)
    {
      if (IsCoarseElement(levels, id, mesh.Ids.ElementSlots))
      {
        countCoarse(CellOfCoarseElement(levels, id, mesh.Ids.ElementSlots));
      }
      else
      {
        ++hexes[refinements];
      }
    }
    return hexes;
  }
  for (Index id : mesh.PointIds)
  {
    if (!IsCentre(mesh, id))
    {
      continue;
    }
    const bool isOwned = levels.Finest().Owned().Contains(CellOfCentre(levels.Finest(), mesh, id));
    if (isOwned && IsCoarsePoint(levels, id, mesh.Ids.PointSlots))
    {
      countCoarse(CellOfCoarseCentre(levels, id, mesh.Ids.PointSlots));
    }
    else
    {
      hexes[refinements] += isOwned;
    }
  }
  return hexes;
}

} // namespace

void ReportLevels(
  const Mesh& mesh, const std::vector<Index>& requested, Ranks& ranks, MeshReport& report)
{
  if (mesh.Levels->IsUniform())
  {
    return;
  }
  const int refinements = mesh.Levels->NumberOfRefinements();
  std::vector<std::int64_t> hexes = CountHexes(mesh);
  ranks.Sum(hexes);
  for (int level = 0; level <= refinements; ++level)
  {
    report.Levels.push_back({ 0, 0, 0, hexes[level] });
    if (level < refinements)
    {
      const OctantFamilies::LevelReport& families = mesh.Levels->Families().Report(level);
      MeshReport::Level& last = report.Levels.back();
      last.Families = families.Requested + families.Balance + families.NonManifold;
      last.AddedForBalance = last.Families - families.Requested;
      last.AddedForValidity = families.Requested - requested[level];
    }
  }
  report.TransitionCells = hexes[refinements + 1];
}

} // namespace vfm
