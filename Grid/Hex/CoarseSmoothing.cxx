#include "Hex/CoarseSmoothing.h"

#include "Base/Vector3.h"
#include "Hex/HexTopology.h"
#include "Hex/TransitionSmoothing.h"
#include "Mesh/LevelIds.h"
#include "Mesh/Quality.h"
#include "Smoothing/ActiveMeshBuilder.h"
#include "Smoothing/HexEnergy.h"
#include "Smoothing/Smoother.h"

namespace vfm
{
namespace
{

constexpr double TargetScaledJacobian = 0.7;

const SmoothingStage AllHexes{ 2, 0.0, 0.05, 8, 1e-3 }, PoorHexes{ 8, 0.0, 0.01, 25, 1e-3 };
constexpr double GoodScaledJacobian = 0.75; // at least: no poor hex

/// The base nodes, most of them, at which all cells are known and none is refined or beside a refined one: they stay.
std::vector<bool> FindNodesFarFromRefined(const CoarseHexes& coarse)
{
  const CartesianGrid& base = coarse.Levels().Base();
  std::vector<bool> isFar(base.NumberOfEntries(), false);
  IndexBox inside = base.Extended(1);
  inside.Lower = CornerOfCell(inside.Lower, 7); // nodes: none at the rim
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

/// The points that move, and the hexes at them.
class CoarseSmoother
{
public:
  CoarseSmoother(const CoarseHexes& coarse, const std::vector<unsigned char>& isFrozen, Mesh& mesh,
    const Partition& partition) :
    Levels(coarse.Levels()), Refined(coarse.Refined()), Result(mesh)
  {
    ActiveMeshBuilder builder(
      8, mesh.PointIds.size(), this->FindMovers(FindNodesFarFromRefined(coarse)));
    const std::vector<Index> hexes = builder.AddAround(mesh);
    this->Active = builder.Finish(&partition, 8 * this->Levels.NumberOfRefinements());
    this->Active.Widths = WidthsOfHexes(this->Levels, mesh, hexes);
    this->Active.PlacePoints(this->Levels.Finest(), mesh);
    for (std::size_t p = 0; p < this->Active.MeshPoint.size(); ++p)
    {
      this->Active.IsActive[p] &= !isFrozen[this->Active.MeshPoint[p]];
    }
  }

  void Run(Runtime& runtime)
  {
    const HexEnergy energy(TargetScaledJacobian);
    Smoother smoother(this->Active, nullptr, energy, runtime);
    smoother.RunStage(AllHexes, [](double) {});
    std::vector<unsigned char> isActive = this->ListPointsOfPoorHexes();
    this->Active.IsActive.swap(isActive);
    smoother.RunStage(PoorHexes, [](double) {});
    this->Active.IsActive.swap(isActive);
    this->Active.CopyTo(this->Result, this->Levels.Finest());
  }

private:
  std::vector<Mover> FindMovers(const std::vector<bool>& isFar) const;
  bool TouchesFinerLevels(Index key, int next) const;
  std::vector<unsigned char> ListPointsOfPoorHexes() const;

  const RefinedGrid& Levels;
  const RefinedMesh& Refined;
  Mesh& Result;
  ActiveMesh Active;
};

/// Whether a cell of the level `next` at a lattice node is refined. The hexes in it lie two levels below the node that the
/// point moves with, so the owner may not know all of them: the point stays.
bool CoarseSmoother::TouchesFinerLevels(Index key, int next) const
{
  if (next >= this->Levels.NumberOfRefinements())
  {
    return false;
  }
  const OctreeKeys& lattice = this->Levels.Lattice();
  const OctreeKeys::LevelIndex node = lattice.NodeOfKey(key);
  const int shift = next - node.Level;
  for (int c = 0; node.Slot == 0 && c < 8; ++c)
  {
    Index3 cell;
    for (int a = 0; a < 3; ++a)
    {
      cell[a] = (node.At[a] << shift) - 1 + (c >> a & 1);
    }
    if (lattice.HasCell(next, cell) && this->Levels.Families().IsRefined(next, cell))
    {
      return true;
    }
  }
  return false;
}

/// Also those that stay: other ranks may ask for them.
std::vector<Mover> CoarseSmoother::FindMovers(const std::vector<bool>& isFar) const
{
  std::vector<Mover> movers;
  const OctreeKeys& lattice = this->Levels.Lattice();
  for (std::size_t p = 0; p < this->Result.PointIds.size(); ++p)
  {
    const Index id = this->Result.PointIds[p];
    if (!IsLatticePoint(this->Levels, id, this->Result.Ids.PointSlots))
    {
      continue;
    }
    const Index key = KeyOfPoint(this->Levels, id, this->Result.Ids.PointSlots);
    const OctreeKeys::LevelIndex node = lattice.NodeOfKey(key);
    if (node.Level == 0 && node.Slot == 0 && isFar[this->Levels.Base().Linear(node.At)])
    {
      continue;
    }
    const Index anchor = AnchorOfPoint(this->Levels.Families(), this->Refined, key);
    if (anchor < 0)
    {
      continue;
    }
    const OctreeKeys::LevelIndex at = lattice.NodeOfKey(anchor);
    if (!this->TouchesFinerLevels(key, at.Level + 1))
    {
      movers.push_back({ static_cast<Index>(p), anchor, anchor / OctreeKeys::NodeSlots,
        OwnerNode(at), ColourOfNode(at) });
    }
  }
  return movers;
}

/// Of each point: whether it moves and has a poor hex. All hexes of owned points are known, so ranks agree.
std::vector<unsigned char> CoarseSmoother::ListPointsOfPoorHexes() const
{
  std::vector<unsigned char> isListed(this->Active.X.size(), 0);
  for (auto points = this->Active.Elements.begin(); points != this->Active.Elements.end();
       points += 8)
  {
    std::array<Index, 8> hex;
    for (int c = 0; c < 8; ++c)
    {
      hex[VtkCorner[c]] = points[c];
    }
    if (HexScaledJacobian(this->Active.X[0].data(), hex.data()) < GoodScaledJacobian)
    {
      std::for_each(
        points, points + 8, [&](int point) { isListed[point] = this->Active.IsActive[point]; });
    }
  }
  return isListed;
}

} // namespace

void SmoothCoarse(const CoarseHexes& coarse, const std::vector<unsigned char>& isFrozen, Mesh& mesh,
  Runtime& runtime)
{
  const Partition partition(coarse.Levels().Base(), runtime.Group());
  CoarseSmoother(coarse, isFrozen, mesh, partition).Run(runtime);
}

} // namespace vfm
