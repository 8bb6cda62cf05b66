#include "Smoothing/Tet/MakeCoarseTets.h"

#include "Elements/PeriodicIds.h"
#include "Elements/TetQuality.h"
#include "Octree/RefinedGrid.h"
#include "Smoothing/ActiveMeshBuilder.h"
#include "Smoothing/Hex/MakeLevels.h"
#include "Smoothing/Hex/TransitionSmoothing.h"
#include "Smoothing/Smoother.h"
#include "Smoothing/Tet/TetImprove.h"

namespace vfm
{
namespace
{

constexpr double PoorAngle = 20.0; // distance of a dihedral angle from 0 or 180, degrees

/// Returns whether a tet has a dihedral angle near 0 or 180 degrees. Like the energy, angles are
/// measured in widths of the tet's cell. position: in active.Elements.
bool HasPoorAngle(const ActiveMesh& active, std::size_t position)
{
  const Index corners[4] = { 0, 1, 2, 3 };
  double points[12], angles[6];
  for (int c = 0; c < 4; ++c)
  {
    const Vector3 x = Divided(
      active.X[active.Elements[position + c]], active.WidthsAt(static_cast<Index>(position)));
    std::copy(x.begin(), x.end(), points + 3 * c);
  }
  DihedralAngles(points, corners, angles);
  return std::any_of(
    angles, angles + 6, [](double angle) { return std::min(angle, 180.0 - angle) < PoorAngle; });
}

/// Restricts the active points of this rank to the movers of poor tets. Returns whether there are
/// poor tets.
bool ActivatePoor(ActiveMesh& active)
{
  std::vector<unsigned char> isPoor(active.X.size(), 0);
  bool found = false;
  for (std::size_t t = 0; t < active.Elements.size(); t += 4)
  {
    if (HasPoorAngle(active, t))
    {
      found = true;
      std::for_each(active.Elements.begin() + t, active.Elements.begin() + t + 4,
        [&](int point) { isPoor[point] = 1; });
    }
  }
  for (const MoveOrder::Group& group : active.Order.Groups())
  {
    std::copy(isPoor.begin() + group.First, isPoor.begin() + group.Last,
      active.IsActive.begin() + group.First);
  }
  return found;
}

std::vector<Mover> ListMovers(const CoarseTets& tets, int level)
{
  std::vector<Mover> movers;
  tets.ForFreePoints(level,
    [&](int point, const OctreeKeys::LevelIndex& node)
    {
      movers.push_back(
        { point, tets.Points().PointIds[point], tets.Levels().Lattice().NodeKey(level, node.At, 0),
          OwnerNode(node), CartesianGrid::Parities(node.At) });
    });
  return movers;
}

/// Reduces the energy of poor tets by moving the free points of a level.
/// @param partition  partition of the base grid, whose nodes own the movers (Mover::Owner)
/// @pre Collective.
void SmoothLevel(int level, const TetEnergy& energy, const Partition& partition, Runtime& runtime,
  CoarseTets& tets)
{
  Mesh& mesh = tets.Points();
  ActiveMeshBuilder builder(4, mesh.Points.size() / 3, ListMovers(tets, level));
  std::vector<Vector3> widths;
  tets.ForFreeTets(
    [&](const CoarseTets::Tet& tet, const Vector3& widthsOfTet)
    {
      if (builder.HasMover(tet.data()))
      {
        builder.Add(tet.data());
        widths.push_back(widthsOfTet);
      }
    });
  ActiveMesh active =
    builder.Finish(partition, CopiesOfMovers(mesh, mesh.Levels->NumberOfRefinements()), 8);
  active.Widths = std::move(widths);
  active.PlacePoints(tets.Levels().Finest(), mesh);
  if (runtime.Group().Any(ActivatePoor(active)))
  {
    Smoother(active, nullptr, energy, runtime).RunRamp(TetRamp());
    active.CopyTo(mesh, tets.Levels().Finest());
  }
}

struct SmoothedTets
{
  std::unique_ptr<CoarseTets> Tets;
  /// Families to refine because tets in owned base cells are not positive, one list per refinement.
  /// If there are any on a rank, levels and tets must be made again.
  std::vector<std::vector<Index>> BadFamilies;
};

/// Makes the tets, or none if the grid has no refinements.
/// @param hexes  coarse hexes that are not split; they are consumed (CoarseHexes::Visit)
/// @throws InputError  if ids or numbers of points are too large
/// Collective.
SmoothedTets SmoothTets(CoarseHexes& hexes, const TetEnergy& energy, Runtime& runtime)
{
  static_assert(CoarseTets::InvalidWay == InvalidEnergy, "Tets are valid in both or none.");
  SmoothedTets made{ std::make_unique<CoarseTets>(hexes, runtime.Group()), {} };
  CoarseTets& tets = *made.Tets;
  if (tets.Levels().IsUniform())
  {
    return made;
  }
  const auto energyOf = [&energy](const CoarseTets::FourTets& corners, const Vector3& widths)
  {
    const std::array<double, 4> e = energy.OfTets(corners, widths, TetRamp().back());
    return std::max({ e[0], e[1], e[2], e[3] }) >= InvalidEnergy ? InvalidEnergy
                                                                 : (e[0] + e[1]) + (e[2] + e[3]);
  };
  tets.ChooseWays(energyOf, runtime);
  made.BadFamilies = tets.FindBadFamilies(energyOf);
  if (runtime.Group().Any(std::any_of(made.BadFamilies.begin(), made.BadFamilies.end(),
        [](const std::vector<Index>& families) { return !families.empty(); })))
  {
    return made;
  }
  const Partition partition(tets.Levels().Base(), runtime.Group());
  for (int level = 0; level < tets.Levels().NumberOfRefinements(); ++level)
  {
    SmoothLevel(level, energy, partition, runtime, tets);
  }
  tets.ChooseWays(energyOf, runtime);
  return made;
}

} // namespace

std::unique_ptr<const CoarseTets> MakeCoarseTets(const MeshCells& cells, const LabelArray& labels,
  const std::vector<Index>& crossed, const TetEnergy& energy, MeshRun& run, LevelHexes& levels)
{
  LevelPlan plan = cells.Options.Levels;
  for (;; ++run.Report.LevelRounds)
  {
    MakeLevels(cells.Grid, labels, crossed, { cells.Options.MeshVoid, true, true }, plan,
      run.TheRuntime, run.Report, levels);
    SmoothedTets made = SmoothTets(*levels.Coarse, energy, run.TheRuntime);
    if (!AddFamilies(made.BadFamilies, plan, run.Group()))
    {
      return std::move(made.Tets);
    }
  }
}

} // namespace vfm
