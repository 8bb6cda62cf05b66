#include "Smoothing/Tet/DiagonalFlips.h"

#include "Base/HexNumbering.h"
#include "Base/Sorted.h"
#include "Elements/PeriodicIds.h"
#include "Elements/Tet/LeafNodes.h"
#include "Octree/LevelIds.h"

#include <cmath>

namespace vfm
{
namespace
{

constexpr double SmallestGain = 1e-6; // relative gain required of a flip

/// Returns a number of the face of the grid that a tet surrounds.
Index FaceOfId(Index id)
{
  return (id - 1) / (4 * PiecesPerTet);
}

bool IsCoarse(const Mesh& mesh, Index id)
{
  return IsCoarseTet(*mesh.Levels, id, TetIds.ElementSlots);
}

/// Returns the id of the copy of a tet that is some cells of the finest grid lower.
Index IdBelow(const Mesh& mesh, Index id, const Index3& cells)
{
  const RefinedGrid& levels = *mesh.Levels;
  if (!IsCoarse(mesh, id))
  {
    return id - TetIds.ElementSlots * levels.Finest().NodeKey(cells);
  }
  const OctreeKeys::LevelIndex cell =
    Below(CellOfCoarseTet(levels, id, TetIds.ElementSlots), cells, levels.NumberOfRefinements());
  const Index number = (id - TetId(levels, 0, 0, TetIds.ElementSlots)) % TetsOfCell;
  return TetId(
    levels, levels.Lattice().HexKey(cell.Level, cell.At, 0), number, TetIds.ElementSlots);
}

OctreeKeys::LevelIndex CellBeyond(OctreeKeys::LevelIndex leaf, int side)
{
  leaf.At[side / 2] += side % 2 == 1 ? 1 : -1;
  return leaf;
}

/// Returns whether a side of a leaf is on another leaf of its level, or on the domain boundary.
bool IsAtEqualLeaf(const RefinedGrid& levels, const OctreeKeys::LevelIndex& leaf, int side)
{
  const OctreeKeys::LevelIndex beyond = CellBeyond(leaf, side);
  const bool isInside = levels.Lattice().HasCell(beyond.Level, beyond.At);
  const bool isLarger =
    leaf.Level > 0 && !IsRefined(levels, { leaf.Level - 1, ParentOfCell(beyond.At), 0 });
  return !isInside || (!isLarger && !IsRefined(levels, beyond));
}

/// Returns whether an edge of a side of a leaf has a midpoint.
bool HasMidpoints(const RefinedGrid& levels, const OctreeKeys::LevelIndex& leaf, int side)
{
  bool has = false;
  for (int k = 0; k < 4 && !has; ++k)
  {
    has = HasMidpoint(levels, leaf, FaceCorners[side][k], FaceCorners[side][(k + 1) % 4]);
  }
  return has;
}

} // namespace

DiagonalFlips::DiagonalFlips(const Mesh& mesh, const BarrierElements& barrier,
  const Partition& partition, ActiveMesh& active, const TetEnergy& energy,
  const std::vector<FeatureKind>& kinds) :
  Crossing(!mesh.Levels->HasFineInterfaces()),
  Parts(partition),
  Active(active),
  Energy(energy),
  Kinds(kinds)
{
  this->FindFineQuads(mesh, barrier);
  if (this->Crossing)
  {
    this->FindCoarseQuads(mesh, barrier);
  }
  if (mesh.Levels->Finest().IsPeriodic())
  {
    this->FindCopies(mesh);
  }
}

/// The tets at a quad are consecutive, the two tets on its lower side first (CellTets.cxx).
void DiagonalFlips::FindFineQuads(const Mesh& mesh, const BarrierElements& barrier)
{
  const std::vector<Index>& tets = this->Active.MeshElement;
  const auto faceOf = [&](std::size_t tet) { return FaceOfId(mesh.ElementIds[tets[tet]]); };
  for (std::size_t first = 0, last = 0; first < tets.size(); first = last)
  {
    for (last = first; last < tets.size() && faceOf(last) == faceOf(first); ++last)
    {
    }
    const Index point = this->Active.MeshPoint[this->Active.Elements[4 * first]];
    // The first point is a corner of the quad, or the centre of an inner face's lower cell.
    const bool isHalf = SlotOfPoint(mesh.PointIds[point]) == VertexSlot &&
      !IsCoarse(mesh, mesh.ElementIds[tets[first]]);
    if (isHalf && (last - first) % 2 == 0)
    {
      const Index at = static_cast<Index>(first);
      this->AddQuad(
        { { at, at + 1, at + 2, at + 3 } }, static_cast<int>(last - first) / 2, mesh, barrier);
    }
  }
}

/// Lists the sides of larger leaves whose quads may be flipped, ascending. Both halves of these are
/// active.
std::vector<DiagonalFlips::LeafSide> DiagonalFlips::ListLeafSides(const Mesh& mesh) const
{
  const RefinedGrid& levels = *mesh.Levels;
  const std::vector<Index>& tets = this->Active.MeshElement;
  const Index start = TetId(levels, 0, 0, TetIds.ElementSlots), perSide = TetsOfCell / 6;
  std::vector<LeafSide> sides;
  for (std::size_t at = 0; at + 1 < tets.size(); ++at)
  {
    const Index number = mesh.ElementIds[tets[at]] - start;
    // Only a quad has tets 0 and 1, if no edge of the face has a midpoint.
    if (number < 0 || number % perSide != 0 || mesh.ElementIds[tets[at + 1]] != start + number + 1)
    {
      continue;
    }
    const OctreeKeys::LevelIndex leaf =
      CellOfCoarseTet(levels, start + number, TetIds.ElementSlots);
    const int side = static_cast<int>(number / perSide % 6);
    if (IsAtEqualLeaf(levels, leaf, side) && !HasMidpoints(levels, leaf, side))
    {
      sides.push_back({ number / perSide, static_cast<Index>(at) });
    }
  }
  return sides;
}

/// Other halves of a face meet at the centre of the face of a larger leaf, and cannot be flipped.
void DiagonalFlips::FindCoarseQuads(const Mesh& mesh, const BarrierElements& barrier)
{
  const RefinedGrid& levels = *mesh.Levels;
  const std::vector<LeafSide> sides = this->ListLeafSides(mesh);
  for (const LeafSide& side : sides)
  {
    const OctreeKeys::LevelIndex leaf = CellOfCoarseTet(
      levels, mesh.ElementIds[this->Active.MeshElement[side.First]], TetIds.ElementSlots);
    const int face = static_cast<int>(side.Key % 6);
    const OctreeKeys::LevelIndex beyond = CellBeyond(leaf, face);
    auto other = sides.end();
    if (levels.Lattice().HasCell(beyond.Level, beyond.At))
    {
      const Index key =
        6 * (levels.Lattice().HexKey(beyond.Level, beyond.At, 0) / OctreeKeys::HexSlots) +
        (face ^ 1);
      other = std::lower_bound(sides.begin(), sides.end(), key,
        [](const LeafSide& a, Index value) { return a.Key < value; });
      other = other != sides.end() && other->Key == key ? other : sides.end();
    }
    if (other == sides.end())
    {
      this->AddQuad({ { side.First + 1, side.First, -1, -1 } }, 1, mesh, barrier);
    }
    else if (face % 2 == 1) // once
    {
      this->AddQuad(
        { { side.First + 1, side.First, other->First + 1, other->First } }, 2, mesh, barrier);
    }
  }
}

void DiagonalFlips::AddQuad(
  const std::array<Index, 4>& tets, int sides, const Mesh& mesh, const BarrierElements& barrier)
{
  const auto isBarrier = [&](Index tet)
  { return barrier.Contain(mesh, this->Active.MeshElement[tet]); };
  this->Quads.push_back({ tets, sides, { isBarrier(tets[0]), isBarrier(tets[2 * sides - 1]) } });
}

/// Requests the choices of copies that this rank does not own.
void DiagonalFlips::FindCopies(const Mesh& mesh)
{
  const auto idOf = [&](const Quad& quad)
  { return mesh.ElementIds[this->Active.MeshElement[quad.Tets[0]]]; };
  this->OfPeers.resize(this->Parts.Peers().size());
  std::vector<std::vector<Index>> quads(this->OfPeers.size()); // ids of their first tets
  for (std::size_t q = 0; q < this->Quads.size(); ++q)
  {
    const Index id = idOf(this->Quads[q]);
    const Index3 cell = CellOfElement(mesh.Levels->Finest(), mesh, id);
    if (!this->Parts.OwnsCell(cell))
    {
      const int peer = this->Parts.PeerOfCell(cell);
      this->OfPeers[peer].push_back(static_cast<Index>(q));
      quads[peer].push_back(IdBelow(mesh, id, this->Parts.ShiftOf(peer)));
    }
  }
  std::vector<Index> own;
  for (const Quad& quad : this->Quads)
  {
    own.push_back(idOf(quad));
  }
  this->ForPeers =
    MapLists(this->Parts.Exchange(quads), [&](Index id) { return FindSorted(own, id); });
}

/// Replaces the choices of copies by those of their owners.
void DiagonalFlips::TakeChoices(std::vector<unsigned char>& isBetter) const
{
  const std::vector<std::vector<unsigned char>> choices =
    this->Parts.Exchange(MapLists(this->ForPeers, [&](Index q) { return isBetter[q]; }));
  for (std::size_t peer = 0; peer < choices.size(); ++peer)
  {
    for (std::size_t i = 0; i < choices[peer].size(); ++i)
    {
      isBetter[this->OfPeers[peer][i]] = choices[peer][i];
    }
  }
}

DiagonalFlips::Tets DiagonalFlips::TetsOf(const Quad& quad) const
{
  Tets tets;
  for (int t = 0; t < 4; ++t) // repeats the tets if there is one side
  {
    std::copy_n(
      this->Active.Elements.begin() + 4 * quad.Tets[t % (2 * quad.Sides)], 4, tets[t].begin());
  }
  return tets;
}

/// Flips (q0 q1 q2 c) (q0 q2 q3 c) to (q1 q2 q3 c) (q1 q3 q0 c).
DiagonalFlips::Tets DiagonalFlips::Flipped(const Tets& tets)
{
  Tets flipped;
  for (int side = 0; side < 4; side += 2)
  {
    const std::array<int, 4>&a = tets[side], &b = tets[side + 1];
    flipped[side] = { { a[1], a[2], b[2], a[3] } };
    flipped[side + 1] = { { a[1], b[2], a[0], a[3] } };
  }
  return flipped;
}

/// Returns the number of ends of the diagonal that are on a sharp edge.
int DiagonalFlips::CarriersOf(const Tets& tets) const
{
  return IsCarrier(this->Kinds[tets[0][0]]) + IsCarrier(this->Kinds[tets[0][2]]);
}

bool DiagonalFlips::IsBetter(
  const Quad& quad, const Tets& tets, const Tets& other, const SmoothingStage& stage) const
{
  const int carriers = this->CarriersOf(tets), others = this->CarriersOf(other);
  if (std::abs(carriers - others) == 2) // both ends of one diagonal, no end of the other
  {
    return others == 2 && this->EnergyOf(quad, other, stage) < InvalidEnergy;
  }
  const double before = this->EnergyOf(quad, tets, stage);
  return this->EnergyOf(quad, other, stage) < before - SmallestGain * std::fabs(before);
}

double DiagonalFlips::EnergyOf(
  const Quad& quad, const Tets& tets, const SmoothingStage& stage) const
{
  Vector3 corners[4][4];
  for (int t = 0; t < 4; ++t)
  {
    for (int c = 0; c < 4; ++c)
    {
      corners[t][c] = this->Active.X[tets[t][c]];
    }
  }
  std::array<double, 4> energies =
    this->Energy.OfTets(corners, this->Active.WidthsAt(4 * quad.Tets[0]), stage);
  for (int t = 0; t < 2 * quad.Sides; ++t)
  {
    // Tets that are only a barrier must be positive, but their shape does not count.
    if (quad.IsBarrier[t / 2] && energies[t] < InvalidEnergy)
    {
      energies[t] = 0.0;
    }
  }
  return (energies[0] + energies[1]) + (energies[2] + energies[3]);
}

void DiagonalFlips::Run(const SmoothingStage& stage, const std::function<void(int)>& changed)
{
  std::vector<unsigned char> isBetter;
  for (const Quad& quad : this->Quads)
  {
    const Tets tets = this->TetsOf(quad);
    isBetter.push_back(this->IsBetter(quad, tets, Flipped(tets), stage));
  }
  if (!this->OfPeers.empty())
  {
    this->TakeChoices(isBetter);
  }
  std::vector<Index> flipped;
  for (std::size_t q = 0; q < this->Quads.size(); ++q)
  {
    const Quad& quad = this->Quads[q];
    if (isBetter[q])
    {
      const Tets other = Flipped(this->TetsOf(quad));
      for (int t = 0; t < 2 * quad.Sides; ++t)
      {
        std::copy(
          other[t].begin(), other[t].end(), this->Active.Elements.begin() + 4 * quad.Tets[t]);
      }
      for (int t = 0; this->Crossing && t < 2 * quad.Sides; ++t)
      {
        flipped.insert(flipped.end(), other[t].begin(), other[t].end());
      }
      if (!this->Crossing)
      {
        // Omits the centre, which is near points of ranks that do not have this quad.
        flipped.insert(flipped.end(), other[0].begin(), other[0].begin() + 3);
      }
    }
  }
  if (!flipped.empty())
  {
    this->Active.ListCorners();
    std::for_each(flipped.begin(), flipped.end(), changed);
  }
}

void DiagonalFlips::CopyTo(Mesh& mesh) const
{
  for (std::size_t t = 0; t < this->Active.MeshElement.size(); ++t)
  {
    for (int c = 0; c < 4; ++c)
    {
      mesh.Elements[4 * this->Active.MeshElement[t] + c] =
        this->Active.MeshPoint[this->Active.Elements[4 * t + c]];
    }
  }
}

} // namespace vfm
