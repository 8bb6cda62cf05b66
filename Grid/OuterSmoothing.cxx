#include "OuterSmoothing.h"

#include "HexEnergy.h"
#include "HexTopology.h"
#include "Smoother.h"
#include "TransitionSmoothing.h"
#include "Vector3.h"

#include <unordered_map>

namespace vfm
{
namespace
{

constexpr double TargetScaledJacobian = 0.7;

const SmoothingRamp Ramp{ { 1, 0.0, 0.1, 5, 1e-3 }, { 2, 0.0, 0.05, 8, 1e-3 },
  { 8, 0.0, 0.01, 25, 1e-3 } };

/// The base nodes at cells that are refined or beside one, and those at the rim, whose cells are not all known. All others,
/// most of them, stay.
std::vector<bool> FindNodesNearRefined(const OuterHexes& outer)
{
  const CartesianGrid& base = outer.Levels().Base();
  std::vector<bool> isNear(base.NumberOfEntries(), false);
  for (Index key : outer.Refined().TouchedCells)
  {
    const Index cell =
      base.Linear(outer.Levels().Lattice().HexOfKey(RefinedLattice::HexSlots * key).At);
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

/// The points that stem from nodes of one level, and the hexes at them.
class LevelSmoother
{
public:
  LevelSmoother(const OuterHexes& outer, int level, const std::vector<unsigned char>& isFrozen,
    const std::vector<bool>& isNear, Mesh& mesh, const Partition& partition) :
    Levels(outer.Levels()), Refined(outer.Refined()), Level(level), Result(mesh), Parts(partition)
  {
    this->FindMoving(isFrozen, isNear);
    this->AddHexes();
    this->Active.FixOnDomain(this->Levels.Finest(), mesh);
    this->Active.AttachmentOffset.assign(this->Active.X.size() + 1, 0);
    this->Active.ListCorners();
    this->AddGroups();
  }

  void Run(Runtime& runtime)
  {
    std::vector<PointExchange::Entry> entries;
    for (const Mover& mover : this->Movers)
    {
      entries.push_back({ mover.Point, mover.Place, OwnerNode(mover.At),
        CartesianGrid::Colour(mover.At.At), true });
    }
    const PointExchange exchange(entries, this->Parts);
    const HexEnergy energy(TargetScaledJacobian);
    Smoother smoother(this->Active, nullptr, exchange, energy, runtime);
    for (const SmoothingStage& stage : Ramp)
    {
      smoother.RunStage(stage, [](double) {});
    }
    this->Active.CopyTo(this->Result, this->Levels.Finest());
  }

private:
  struct Mover
  {
    Index Place;
    RefinedLattice::Place At;
    Index MeshPoint;
    int Point; // of Active
    bool IsFrozen;
  };

  void FindMoving(const std::vector<unsigned char>& isFrozen, const std::vector<bool>& isNear);
  bool TouchesFinerLevels(Index key) const;
  void AddHexes();
  int AddPoint(Index meshPoint, bool moves);
  Vector3 WidthsOf(Index hex) const;
  void AddGroups();

  const RefinedGrid& Levels;
  const RefinedMesh& Refined;
  int Level;
  Mesh& Result;
  const Partition& Parts;
  std::vector<Mover> Movers; // by place: the points of one node in turn
  ActiveMesh Active;
};

/// Whether cells of the next level at a lattice node are refined once more: their hexes are not known around it.
bool LevelSmoother::TouchesFinerLevels(Index key) const
{
  const int next = this->Level + 1;
  if (next >= this->Levels.NumberOfRefinements())
  {
    return false;
  }
  const RefinedLattice& lattice = this->Levels.Lattice();
  const RefinedLattice::Place place = lattice.NodeOfKey(key);
  const int shift = next - place.Level;
  for (int c = 0; place.Slot == 0 && c < 8; ++c)
  {
    Index3 cell;
    for (int a = 0; a < 3; ++a)
    {
      cell[a] = (place.At[a] << shift) - 1 + (c >> a & 1);
    }
    if (lattice.HasCell(next, cell) && this->Levels.Octets().IsRefined(next, cell))
    {
      return true;
    }
  }
  return false;
}

void LevelSmoother::FindMoving(
  const std::vector<unsigned char>& isFrozen, const std::vector<bool>& isNear)
{
  const RefinedLattice& lattice = this->Levels.Lattice();
  const std::vector<Index>& keys = this->Refined.PointKeys;
  for (std::size_t p = 0; p < this->Result.PointIds.size(); ++p)
  {
    const Index id = this->Result.PointIds[p];
    if (!this->Levels.IsLatticePoint(id, this->Result.PointSlots))
    {
      continue;
    }
    const Index key = this->Levels.KeyOfPoint(id, this->Result.PointSlots);
    const RefinedLattice::Place node = lattice.NodeOfKey(key);
    if (node.Level == 0 && node.Slot == 0 && !isNear[this->Levels.Base().Linear(node.At)])
    {
      continue;
    }
    const auto at = std::lower_bound(keys.begin(), keys.end(), key);
    const Index place = at != keys.end() && *at == key ? this->Refined.Places[at - keys.begin()]
                                                       : PlaceOfNode(this->Levels.Octets(), key);
    if (place >= 0 && lattice.NodeOfKey(place).Level == this->Level &&
      !this->TouchesFinerLevels(key))
    {
      this->Movers.push_back(
        { place, lattice.NodeOfKey(place), static_cast<Index>(p), -1, isFrozen[p] != 0 });
    }
  }
  std::sort(this->Movers.begin(), this->Movers.end(),
    [](const Mover& a, const Mover& b) { return a.Place < b.Place; });
}

/// The movers first, then the other points of their hexes.
void LevelSmoother::AddHexes()
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
  for (std::size_t h = 0; h < this->Result.ElementIds.size(); ++h)
  {
    const Index* hex = this->Result.Elements.data() + 8 * h;
    if (std::none_of(hex, hex + 8, [&](Index p) { return isMoving[p]; }))
    {
      continue;
    }
    for (int c = 0; c < 8; ++c)
    {
      const auto at = pointOf.try_emplace(hex[VtkCorner[c]], -1).first;
      at->second = at->second < 0 ? this->AddPoint(at->first, false) : at->second;
      this->Active.Elements.push_back(at->second);
    }
    this->Active.Widths.push_back(this->WidthsOf(static_cast<Index>(h)));
  }
}

int LevelSmoother::AddPoint(Index meshPoint, bool moves)
{
  this->Active.AddPoint(this->Levels.Finest(), this->Result, meshPoint, moves);
  return static_cast<int>(this->Active.X.size()) - 1;
}

/// Of the cell that a hex is, or lies in; grid coordinates.
Vector3 LevelSmoother::WidthsOf(Index hex) const
{
  const Index id = this->Result.ElementIds[hex];
  const CartesianGrid& grid = this->Levels.Finest();
  if (!this->Levels.IsOuterElement(id, this->Result.ElementSlots))
  {
    return CellWidths(grid, CellOfElement(grid, this->Result, id));
  }
  const RefinedLattice::Place cell = this->Levels.CellOfOuterElement(id, this->Result.ElementSlots);
  return (1.0 / grid.MeanWidth()) * this->Levels.Lattice().CellWidths(cell.Level, cell.At);
}

/// Only the points that this rank owns move here.
void LevelSmoother::AddGroups()
{
  Index last = -1;
  for (const Mover& mover : this->Movers)
  {
    if (!this->Parts.OwnsNode(OwnerNode(mover.At)))
    {
      continue;
    }
    std::vector<ActiveMesh::Group>& groups =
      this->Active.Colours[CartesianGrid::Colour(mover.At.At)];
    const Index node = mover.Place / RefinedLattice::NodeSlots;
    if (node != last)
    {
      groups.push_back({ mover.Point, mover.Point });
      last = node;
    }
    ++groups.back().Last;
  }
}

} // namespace

void SmoothOuter(
  const OuterHexes& outer, const std::vector<unsigned char>& isFrozen, Mesh& mesh, Runtime& runtime)
{
  const Partition partition(outer.Levels().Base(), runtime.Group());
  const std::vector<bool> isNear = FindNodesNearRefined(outer);
  for (int level = 0; level < outer.Levels().NumberOfRefinements(); ++level)
  {
    LevelSmoother(outer, level, isFrozen, isNear, mesh, partition).Run(runtime);
  }
}

} // namespace vfm
