#include "Smoothing/Hex/ActiveHexes.h"

#include "Base/Groups.h"
#include "Elements/Hex/NodesNear.h"
#include "Elements/PeriodicIds.h"
#include "Octree/LevelIds.h"
#include "Smoothing/ActiveMeshBuilder.h"
#include "Smoothing/Attach.h"
#include "Smoothing/Hex/TransitionSmoothing.h"

namespace vfm
{
namespace
{

constexpr Index Rings = 2;            // points within this number of cells around interfaces move
constexpr Index PointsOfBlock = 4096; // points per task

/// Data that determine which points move, and with which nodes.
struct Work
{
  const LabelledGrid& Labelled;
  const Mesh& Input;
  const CoarseHexes& Coarse = *Labelled.Levels.Coarse;
  const RefinedGrid& Levels = *Labelled.Levels.Grid;
  /// Number of levels from the coarsest one with interfaces to the finest.
  const int Halvings = Levels.HasFineInterfaces() ? 0 : Levels.NumberOfRefinements();
  /// Nodes near interfaces by halvings. The last entry, for the coarsest level, includes all points
  /// that move.
  std::vector<NodesNear> Near{};
};

bool MayMove(const Work& work, Index id)
{
  const Index3 node = NodeOfPoint(work.Levels.Finest(), work.Input, id);
  const int shift = work.Halvings;
  return work.Near.back().Has({ { node[0] >> shift, node[1] >> shift, node[2] >> shift } });
}

void AddMover(const Work& work, Index point, std::vector<Mover>& movers)
{
  const Index id = work.Input.PointIds[point];
  if (!MayMove(work, id))
  {
    return;
  }
  const OctreeKeys::LevelIndex node = work.Coarse.AnchorOf(work.Input, id);
  const int halvings = work.Levels.NumberOfRefinements() - node.Level;
  if (halvings <= work.Halvings && work.Near[halvings].Has(node.At))
  {
    movers.push_back({ point, id, work.Levels.Lattice().NodeKey(node.Level, node.At, 0),
      work.Levels.FinestNode(node.Level, node.At),
      work.Levels.IsUniform() ? work.Levels.Finest().Colour(node.At) : ColourOfNode(node) });
  }
}

std::vector<Mover> FindMovers(const LabelledGrid& labelled, const Mesh& mesh, Runtime& runtime)
{
  Work work{ labelled, mesh };
  for (int halvings = 0; halvings <= work.Halvings; ++halvings)
  {
    work.Near.emplace_back(work.Levels.Finest(), labelled.Mixed, halvings, Rings);
  }
  if (work.Halvings > 0)
  {
    work.Near.emplace_back(work.Levels.Finest(), labelled.Mixed, work.Halvings, Rings + 1);
  }
  return CollectItems<Mover>(runtime, mesh.PointIds.size(), PointsOfBlock,
    [&](Index point, std::vector<Mover>& movers) { AddMover(work, point, movers); });
}

} // namespace

ActiveMesh MakeActiveHexes(
  const LabelledGrid& labelled, const Partition& partition, const Mesh& mesh, Runtime& runtime)
{
  const RefinedGrid& levels = *labelled.Levels.Grid;
  ActiveMeshBuilder builder(8, mesh.PointIds.size(), FindMovers(labelled, mesh, runtime));
  const std::vector<Index> hexes = builder.AddAround(mesh, runtime);
  const int colours = levels.Finest().NumberOfColours();
  const bool hasPlanes = levels.HasFineInterfaces() && colours == 8;
  ActiveMesh active =
    builder.Finish(partition, CopiesOfMovers(mesh), colours * (levels.NumberOfRefinements() + 1),
      hasPlanes ? ActiveMeshBuilder::Nodes::OfGrid : ActiveMeshBuilder::Nodes::Any);
  active.Widths = levels.HasFineInterfaces() ? WidthsOfCells(levels.Finest(), mesh, hexes)
                                             : WidthsOfHexes(levels, mesh, hexes);
  active.SetBarrier(mesh, hexes);
  active.PlacePoints(levels.Finest(), mesh);
  return active;
}

void AttachHexes(const LevelInterfaces& interfaces, const CoarseHexes& coarse, const Mesh& mesh,
  const std::vector<Facet>& facets, Runtime& runtime, ActiveMesh& active)
{
  const RefinedGrid& levels = coarse.Levels();
  const auto findTarget = [&](int point, const std::array<int, 2>& labels)
  {
    const Index id = mesh.PointIds[active.MeshPoint[point]];
    Index target = -1;
    if (!IsCoarsePoint(levels, id, mesh.Ids.PointSlots))
    {
      target = interfaces.FindTarget(
        levels.NumberOfRefinements(), NodeOfPoint(levels.Finest(), mesh, id), labels);
    }
    if (target < 0)
    {
      const OctreeKeys::LevelIndex node = coarse.AnchorOf(mesh, id);
      target = interfaces.FindTarget(node.Level, node.At, labels);
    }
    return target;
  };
  AttachToFacets(facets, findTarget, runtime, active);
}

} // namespace vfm
