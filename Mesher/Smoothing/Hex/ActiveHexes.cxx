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

constexpr Index PointsOfBlock = 4096; // per task

/// Nodes near interfaces, on all levels that have interfaces.
struct NearInterfaces
{
  int Halvings; ///< number of levels from the coarsest one with interfaces to the finest
  /// Nodes by halvings. The last entry, for the coarsest level, includes all points that move.
  std::vector<NodesNear> Nodes;

  NearInterfaces(const RefinedGrid& levels, const std::vector<Index>& mixed) :
    Halvings(levels.HasFineInterfaces() ? 0 : levels.NumberOfRefinements())
  {
    for (int halvings = 0; halvings <= this->Halvings; ++halvings)
    {
      this->Nodes.emplace_back(levels.Finest(), mixed, halvings, MovingRings);
    }
    if (this->Halvings > 0)
    {
      this->Nodes.emplace_back(levels.Finest(), mixed, this->Halvings, MovingRings + 1);
    }
  }

  /// Returns whether points of a node of the finest grid may move.
  bool MayMove(const Index3& node) const
  {
    const int shift = this->Halvings;
    return this->Nodes.back().Has({ { node[0] >> shift, node[1] >> shift, node[2] >> shift } });
  }
  /// Returns whether a node of a level is near interfaces.
  bool Has(int halvings, const Index3& node) const
  {
    return halvings <= this->Halvings && this->Nodes[halvings].Has(node);
  }
};

void AddMover(const CoarseHexes& coarse, const NearInterfaces& near, const Mesh& mesh, Index point,
  std::vector<Mover>& movers)
{
  const RefinedGrid& levels = coarse.Levels();
  const Index id = mesh.PointIds[point];
  if (!near.MayMove(NodeOfPoint(levels.Finest(), mesh, id)))
  {
    return;
  }
  const OctreeKeys::LevelIndex node = coarse.AnchorOf(mesh, id);
  if (near.Has(levels.NumberOfRefinements() - node.Level, node.At))
  {
    movers.push_back({ point, id, levels.Lattice().NodeKey(node.Level, node.At, 0),
      levels.FinestNode(node.Level, node.At),
      levels.IsUniform() ? levels.Finest().Colour(node.At) : ColourOfNode(node) });
  }
}

std::vector<Mover> FindMovers(const LabelledGrid& labelled, const Mesh& mesh, Runtime& runtime)
{
  const NearInterfaces near(*labelled.Levels.Grid, labelled.Mixed);
  return CollectItems<Mover>(runtime, mesh.PointIds.size(), PointsOfBlock,
    [&](Index point, std::vector<Mover>& movers)
    { AddMover(*labelled.Levels.Coarse, near, mesh, point, movers); });
}

} // namespace

ActiveMesh MakeActiveHexes(const LabelledGrid& labelled, const Partition& partition,
  const Mesh& mesh, const std::vector<unsigned char>& isThin, Runtime& runtime)
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
                                             : WidthsOfLeaves(levels, mesh, hexes);
  active.SetBarrier(mesh, { !labelled.Narrow.IsEmpty() }, hexes);
  active.SetYielding(mesh, isThin, hexes);
  active.PlacePoints(levels.Finest(), mesh);
  if (!isThin.empty())
  {
    active.MeshElement = hexes;
  }
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
