#include "Hex/ActiveHexes.h"

#include "Base/Groups.h"
#include "Hex/NodesNear.h"
#include "Hex/TransitionSmoothing.h"
#include "Mesh/LevelIds.h"
#include "Smoothing/ActiveMeshBuilder.h"
#include "Smoothing/Attach.h"

namespace vfm
{
namespace
{

constexpr Index Rings = 2;            // cells around interfaces whose points move
constexpr Index PointsOfBlock = 4096; // that are looked at by one thread

/// Which points move, and with which nodes.
class MoverFinder
{
public:
  MoverFinder(const LabelledGrid& labelled, const Mesh& mesh) :
    Coarse(*labelled.Levels.Coarse),
    Levels(*labelled.Levels.Grid),
    Input(mesh),
    Halvings(this->Levels.HasFineInterfaces() ? 0 : this->Levels.NumberOfRefinements())
  {
    for (int halvings = 0; halvings <= this->Halvings; ++halvings)
    {
      this->Near.emplace_back(this->Levels.Finest(), labelled.Mixed, halvings, Rings);
    }
    if (this->Halvings > 0)
    {
      this->Near.emplace_back(this->Levels.Finest(), labelled.Mixed, this->Halvings, Rings + 1);
    }
  }

  std::vector<Mover> Find(Runtime& runtime) const
  {
    const Index points = static_cast<Index>(this->Input.PointIds.size());
    std::vector<std::vector<Mover>> found((points + PointsOfBlock - 1) / PointsOfBlock);
    ForEach(runtime, found.size(),
      [&](Index block)
      {
        const Index first = block * PointsOfBlock;
        for (Index p = first; p < std::min(points, first + PointsOfBlock); ++p)
        {
          this->AddMover(p, found[block]);
        }
      });
    return Joined(found);
  }

private:
  void AddMover(Index point, std::vector<Mover>& movers) const
  {
    const Index id = this->Input.PointIds[point];
    if (!this->MayMove(id))
    {
      return;
    }
    const OctreeKeys::LevelIndex node = this->Coarse.AnchorOf(this->Input, id);
    const int halvings = this->Levels.NumberOfRefinements() - node.Level;
    if (halvings <= this->Halvings && this->Near[halvings].Has(node.At))
    {
      movers.push_back({ point, id, this->Levels.Lattice().NodeKey(node.Level, node.At, 0),
        this->Levels.FinestNode(node.Level, node.At), ColourOfNode(node) });
    }
  }

  bool MayMove(Index id) const
  {
    const Index3 node = NodeOfPoint(this->Levels.Finest(), this->Input, id);
    const int shift = this->Halvings;
    return this->Near.back().Has({ { node[0] >> shift, node[1] >> shift, node[2] >> shift } });
  }

  const CoarseHexes& Coarse;
  const RefinedGrid& Levels;
  const Mesh& Input;
  const int Halvings; // from the coarsest level with interfaces to the finest
  std::vector<NodesNear>
    Near; // by halvings; the last, of the coarsest, is wide enough for all points that move
};

} // namespace

ActiveMesh MakeActiveHexes(
  const LabelledGrid& labelled, const Partition& partition, const Mesh& mesh, Runtime& runtime)
{
  const RefinedGrid& levels = *labelled.Levels.Grid;
  ActiveMeshBuilder builder(8, mesh.PointIds.size(), MoverFinder(labelled, mesh).Find(runtime));
  const std::vector<Index> hexes = builder.AddAround(mesh);
  ActiveMesh active = builder.Finish(&partition, 8 * (levels.NumberOfRefinements() + 1),
    levels.HasFineInterfaces() ? ActiveMeshBuilder::Nodes::OfGrid : ActiveMeshBuilder::Nodes::Any);
  active.Widths = levels.HasFineInterfaces() ? WidthsOfCells(levels.Finest(), mesh, hexes)
                                             : WidthsOfHexes(levels, mesh, hexes);
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
