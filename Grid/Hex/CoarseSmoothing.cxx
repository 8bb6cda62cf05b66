#include "Hex/CoarseSmoothing.h"

#include "Base/Vector3.h"
#include "Hex/HexTopology.h"
#include "Hex/TransitionSmoothing.h"
#include "Mesh/Quality.h"
#include "Smoothing/GuardedHexEnergy.h"
#include "Smoothing/Smoother.h"

#include <unordered_map>

namespace vfm
{
namespace
{

constexpr double TargetScaledJacobian = 0.7;

const SmoothingStage AllHexes{ 2, 0.0, 0.05, 8, 1e-3 }, PoorHexes{ 8, 0.0, 0.01, 25, 1e-3 };
constexpr double GoodScaledJacobian = 0.75; // at least: no poor hex

/// The base nodes at cells that are refined or beside one, and those at the rim, whose cells are not all known. All others,
/// most of them, stay.
std::vector<bool> FindNodesNearRefined(const CoarseHexes& coarse)
{
  const CartesianGrid& base = coarse.Levels().Base();
  std::vector<bool> isNear(base.NumberOfEntries(), false);
  for (Index key : coarse.Refined().TouchedCells)
  {
    const Index cell =
      base.Linear(coarse.Levels().Lattice().HexOfKey(OctreeKeys::HexSlots * key).At);
    for (int c = 0; c < 8; ++c)
    {
      isNear[base.NodeOfCell(cell, c)] = true;
    }
  }
  const IndexBox box = base.Extended(1);
  Index3 p;
  for (p[2] = box.Lower[2]; box.NumberOfCells() > 0 && p[2] <= box.Upper[2]; ++p[2])
  {
    for (p[1] = box.Lower[1]; p[1] <= box.Upper[1]; ++p[1])
    {
      const bool isSide = p[1] == box.Lower[1] || p[1] == box.Upper[1] || p[2] == box.Lower[2] ||
        p[2] == box.Upper[2];
      const Index step = isSide ? 1 : box.Size(0); // only the ends of inner rows
      for (p[0] = box.Lower[0]; p[0] <= box.Upper[0]; p[0] += step)
      {
        isNear[base.Linear(p)] = true;
      }
    }
  }
  return isNear;
}

/// The points that move, and the hexes at them.
class CoarseSmoother
{
public:
  CoarseSmoother(const CoarseHexes& coarse, const std::vector<unsigned char>& isFrozen, Mesh& mesh,
    const Partition& partition) :
    Levels(coarse.Levels()),
    Refined(coarse.Refined()),
    HasSplits(coarse.Splits() != nullptr),
    Result(mesh),
    Parts(partition)
  {
    this->FindMoving(isFrozen, FindNodesNearRefined(coarse));
    this->AddHexes();
    this->Active.FixOnDomain(this->Levels.Finest(), mesh);
    this->Active.AttachmentOffset.assign(this->Active.X.size() + 1, 0);
    this->Active.ListCorners();
    this->AddGroups();
  }

  void Run(Runtime& runtime)
  {
    const PointExchange exchange(
      this->ListEntries(), this->Parts, static_cast<int>(this->Active.Colours.size()));
    std::vector<Mover>().swap(this->Movers);
    const HexEnergy plain(TargetScaledJacobian);
    const GuardedHexEnergy guarded(TargetScaledJacobian);
    const ElementEnergy& energy = this->HasSplits ? guarded : plain;
    Smoother smoother(this->Active, nullptr, exchange, energy, runtime);
    smoother.RunStage(AllHexes, [](double) {});
    std::vector<unsigned char> isActive = this->ListPointsOfPoorHexes();
    this->Active.IsActive.swap(isActive);
    smoother.RunStage(PoorHexes, [](double) {});
    this->Active.IsActive.swap(isActive);
    this->Active.CopyTo(this->Result, this->Levels.Finest());
  }

private:
  struct Mover
  {
    Index Anchor;
    OctreeKeys::LevelIndex At;
    Index MeshPoint;
    int Point; // of Active
    bool IsFrozen;
  };

  void FindMoving(const std::vector<unsigned char>& isFrozen, const std::vector<bool>& isNear);
  bool TouchesFinerLevels(Index key, int next) const;
  void AddHexes();
  int AddPoint(Index meshPoint, bool moves);
  void AddGroups();
  std::vector<PointExchange::Entry> ListEntries() const;
  std::vector<unsigned char> ListPointsOfPoorHexes() const;

  const RefinedGrid& Levels;
  const RefinedMesh& Refined;
  const bool HasSplits;
  Mesh& Result;
  const Partition& Parts;
  std::vector<Mover> Movers; // by anchor: the points of one node in turn
  ActiveMesh Active;
};

/// Whether cells of a level at a lattice node of it are refined once more: their hexes are not known around it.
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

void CoarseSmoother::FindMoving(
  const std::vector<unsigned char>& isFrozen, const std::vector<bool>& isNear)
{
  const OctreeKeys& lattice = this->Levels.Lattice();
  for (std::size_t p = 0; p < this->Result.PointIds.size(); ++p)
  {
    const Index id = this->Result.PointIds[p];
    if (!this->Levels.IsLatticePoint(id, this->Result.Ids.PointSlots))
    {
      continue;
    }
    const Index key = this->Levels.KeyOfPoint(id, this->Result.Ids.PointSlots);
    const OctreeKeys::LevelIndex node = lattice.NodeOfKey(key);
    if (node.Level == 0 && node.Slot == 0 && !isNear[this->Levels.Base().Linear(node.At)])
    {
      continue;
    }
    const Index anchor = AnchorOfPoint(this->Levels.Families(), this->Refined, key);
    if (anchor >= 0 && !this->TouchesFinerLevels(key, lattice.NodeOfKey(anchor).Level + 1))
    {
      this->Movers.push_back(
        { anchor, lattice.NodeOfKey(anchor), static_cast<Index>(p), -1, isFrozen[p] != 0 });
    }
  }
  std::sort(this->Movers.begin(), this->Movers.end(),
    [](const Mover& a, const Mover& b) { return a.Anchor < b.Anchor; });
}

/// The movers first, then the other points of their hexes.
void CoarseSmoother::AddHexes()
{
  std::unordered_map<Index, int> pointOf; // few of the mesh's points
  std::vector<bool> isMoving(this->Result.PointIds.size(), false);
  pointOf.reserve(2 * this->Movers.size());
  for (Mover& mover : this->Movers)
  {
    mover.Point = this->AddPoint(mover.MeshPoint, !mover.IsFrozen);
    pointOf.emplace(mover.MeshPoint, mover.Point);
    isMoving[mover.MeshPoint] = true;
  }
  std::vector<Index> hexes;
  for (std::size_t h = 0; h < this->Result.ElementIds.size(); ++h)
  {
    const Index* hex = this->Result.Elements.data() + 8 * h;
    if (std::any_of(hex, hex + 8, [&](Index p) { return isMoving[p]; }))
    {
      hexes.push_back(static_cast<Index>(h));
    }
  }
  this->Active.Elements.reserve(8 * hexes.size());
  this->Active.Widths.reserve(hexes.size());
  for (Index h : hexes)
  {
    const Index* hex = this->Result.Elements.data() + 8 * h;
    for (int c = 0; c < 8; ++c)
    {
      const auto at = pointOf.try_emplace(hex[VtkCorner[c]], -1).first;
      at->second = at->second < 0 ? this->AddPoint(at->first, false) : at->second;
      this->Active.Elements.push_back(at->second);
    }
    this->Active.Widths.push_back(WidthsOfHex(this->Levels, this->Result, static_cast<Index>(h)));
  }
}

int CoarseSmoother::AddPoint(Index meshPoint, bool moves)
{
  this->Active.AddPoint(this->Levels.Finest(), this->Result, meshPoint, moves);
  return static_cast<int>(this->Active.X.size()) - 1;
}

/// Only the points that this rank owns move here.
void CoarseSmoother::AddGroups()
{
  this->Active.Colours.resize(8 * this->Levels.NumberOfRefinements());
  Index last = -1;
  for (const Mover& mover : this->Movers)
  {
    if (!this->Parts.OwnsNode(OwnerNode(mover.At)))
    {
      continue;
    }
    std::vector<ActiveMesh::Group>& groups = this->Active.Colours[ColourOfNode(mover.At)];
    const Index node = mover.Anchor / OctreeKeys::NodeSlots;
    if (node != last)
    {
      groups.push_back({ mover.Point, mover.Point });
      last = node;
    }
    ++groups.back().Last;
  }
}

std::vector<PointExchange::Entry> CoarseSmoother::ListEntries() const
{
  std::vector<PointExchange::Entry> entries;
  entries.reserve(this->Movers.size());
  for (const Mover& mover : this->Movers)
  {
    entries.push_back(
      { mover.Point, mover.Anchor, OwnerNode(mover.At), ColourOfNode(mover.At), true });
  }
  return entries;
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
