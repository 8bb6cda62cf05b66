#include "Smoothing/Hex/CoarseSmoothing.h"

#include "Base/Vector3.h"
#include "Elements/Hex/HexTopology.h"
#include "Elements/PeriodicIds.h"
#include "Geometry/Quality.h"
#include "Octree/LevelIds.h"
#include "Smoothing/ActiveMeshBuilder.h"
#include "Smoothing/Hex/HexEnergy.h"
#include "Smoothing/Hex/TransitionSmoothing.h"
#include "Smoothing/Smoother.h"

namespace vfm
{
namespace
{

constexpr double TargetScaledJacobian = 0.7;

const SmoothingStage AllHexes{ 2, 0.0, 0.05, 8, 1e-3 }, PoorHexes{ 8, 0.0, 0.01, 25, 1e-3 };
constexpr double GoodScaledJacobian = 0.75; // lower limit; hexes below are poor

/// Returns the base nodes at which all cells are known and no cell is refined or a neighbour of a
/// refined one. Most base nodes are of this kind; they are fixed.
std::vector<bool> FindNodesFarFromRefined(const CoarseHexes& coarse)
{
  const CartesianGrid& base = coarse.Levels().Base();
  std::vector<bool> isFar(base.NumberOfEntries(), false);
  IndexBox inside = base.Extended(1);
  inside.Lower = CornerOfCell(inside.Lower, 7); // nodes not at the rim
  ForCells(inside, [&](const Index3& node) { isFar[base.Linear(node)] = true; });
  for (Index key : coarse.Refined().TouchedCells)
  {
    const Index3 cell = coarse.Levels().Lattice().HexOfKey(OctreeKeys::HexSlots * key).At;
    for (int c = 0; c < 8; ++c)
    {
      isFar[base.Linear(CornerOfCell(cell, c))] = false;
    }
  }
  return isFar;
}

/// Returns whether each point moves and has a poor hex. All hexes of owned points are known, so
/// ranks agree.
std::vector<unsigned char> ListPointsOfPoorHexes(const ActiveMesh& active)
{
  std::vector<unsigned char> isListed(active.X.size(), 0);
  for (auto points = active.Elements.begin(); points != active.Elements.end(); points += 8)
  {
    std::array<Index, 8> hex;
    std::copy_n(points, 8, hex.begin());
    if (HexScaledJacobian(active.X[0].data(), InVtkOrder(hex).data()) < GoodScaledJacobian)
    {
      std::for_each(
        points, points + 8, [&](int point) { isListed[point] = active.IsActive[point]; });
    }
  }
  return isListed;
}

/// Returns whether a cell of level `next` at a lattice node is refined. The hexes in it are two
/// levels below the node with which the point moves, so the owner may not know all of them, and the
/// point is fixed.
bool TouchesFinerLevels(const RefinedGrid& levels, Index key, int next)
{
  if (next >= levels.NumberOfRefinements())
  {
    return false;
  }
  const OctreeKeys& lattice = levels.Lattice();
  const OctreeKeys::LevelIndex node = lattice.NodeOfKey(key);
  const int shift = next - node.Level;
  for (int c = 0; node.Slot == 0 && c < 8; ++c)
  {
    Index3 cell;
    for (int a = 0; a < 3; ++a)
    {
      cell[a] = (node.At[a] << shift) - 1 + (c >> a & 1);
    }
    if (lattice.HasCell(next, cell) && levels.Families().IsRefined(next, cell))
    {
      return true;
    }
  }
  return false;
}

/// Lists movers, including fixed ones, because other ranks may request them.
std::vector<Mover> FindMovers(const CoarseHexes& coarse, const Mesh& mesh)
{
  const RefinedGrid& levels = coarse.Levels();
  const std::vector<bool> isFar = FindNodesFarFromRefined(coarse);
  std::vector<Mover> movers;
  const OctreeKeys& lattice = levels.Lattice();
  for (std::size_t p = 0; p < mesh.PointIds.size(); ++p)
  {
    const Index id = mesh.PointIds[p];
    if (!IsLatticePoint(levels, id, mesh.Ids.PointSlots))
    {
      continue;
    }
    const Index key = KeyOfPoint(levels, id, mesh.Ids.PointSlots);
    const OctreeKeys::LevelIndex node = lattice.NodeOfKey(key);
    if (node.Level == 0 && node.Slot == 0 && isFar[levels.Base().Linear(node.At)])
    {
      continue;
    }
    const Index anchor = AnchorOfPoint(levels.Families(), coarse.Refined(), key);
    if (anchor < 0)
    {
      continue;
    }
    const OctreeKeys::LevelIndex at = lattice.NodeOfKey(anchor);
    if (!TouchesFinerLevels(levels, key, at.Level + 1))
    {
      movers.push_back({ static_cast<Index>(p), anchor, anchor / OctreeKeys::NodeSlots,
        OwnerNode(at), ColourOfNode(at) });
    }
  }
  return movers;
}

} // namespace

void SmoothCoarse(const CoarseHexes& coarse, const std::vector<unsigned char>& isFrozen, Mesh& mesh,
  Runtime& runtime)
{
  const Partition partition(coarse.Levels().Base(), runtime.Group());
  const RefinedGrid& levels = coarse.Levels();
  ActiveMeshBuilder builder(8, mesh.PointIds.size(), FindMovers(coarse, mesh));
  const std::vector<Index> hexes = builder.AddAround(mesh, runtime);
  const double width = levels.Finest().MeanWidth();
  ActiveMesh active =
    builder.Finish(partition, CopiesOfAnchors(levels.Lattice(), { { width, width, width } }),
      8 * levels.NumberOfRefinements());
  active.Widths = WidthsOfLeaves(levels, mesh, hexes);
  active.PlacePoints(levels.Finest(), mesh);
  for (std::size_t p = 0; p < active.MeshPoint.size(); ++p)
  {
    active.IsActive[p] &= !isFrozen[active.MeshPoint[p]];
  }
  const HexEnergy energy(TargetScaledJacobian);
  Smoother smoother(active, nullptr, energy, runtime);
  smoother.RunStage(AllHexes, [](double) {});
  std::vector<unsigned char> isActive = ListPointsOfPoorHexes(active);
  active.IsActive.swap(isActive);
  smoother.RunStage(PoorHexes, [](double) {});
  active.IsActive.swap(isActive);
  active.CopyTo(mesh, levels.Finest());
}

} // namespace vfm
