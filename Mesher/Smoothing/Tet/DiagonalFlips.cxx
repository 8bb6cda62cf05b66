#include "Smoothing/Tet/DiagonalFlips.h"

#include "Base/Sorted.h"
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

} // namespace

/// The tets at a quad are consecutive, the two tets on its lower side first (CellTets.cxx).
DiagonalFlips::DiagonalFlips(const Mesh& mesh, const BarrierElements& barrier,
  const Partition& partition, ActiveMesh& active, const TetEnergy& energy,
  const std::vector<FeatureKind>& kinds) :
  Parts(partition), Active(active), Energy(energy), Kinds(kinds)
{
  const auto faceOf = [&](std::size_t tet)
  { return FaceOfId(mesh.ElementIds[active.MeshElement[tet]]); };
  for (std::size_t first = 0, last = 0; first < active.MeshElement.size(); first = last)
  {
    for (last = first; last < active.MeshElement.size() && faceOf(last) == faceOf(first); ++last)
    {
    }
    const Index point = active.MeshPoint[active.Elements[4 * first]];
    // The first point is a corner of the quad, or the centre of an inner face's lower cell.
    const bool isHalf = SlotOfPoint(mesh.PointIds[point]) == VertexSlot &&
      !IsCoarseTet(*mesh.Levels, mesh.ElementIds[active.MeshElement[first]], TetIds.ElementSlots);
    if (isHalf && (last - first) % 2 == 0)
    {
      this->Quads.push_back({ static_cast<Index>(first), static_cast<int>(last - first) / 2,
        { barrier.Contain(mesh, active.MeshElement[first]),
          barrier.Contain(mesh, active.MeshElement[last - 1]) } });
    }
  }
  if (mesh.Levels->Finest().IsPeriodic())
  {
    this->FindCopies(mesh);
  }
}

/// Requests the choices of copies that this rank does not own.
void DiagonalFlips::FindCopies(const Mesh& mesh)
{
  const auto idOf = [&](const Quad& quad)
  { return mesh.ElementIds[this->Active.MeshElement[quad.First]]; };
  this->OfPeers.resize(this->Parts.Peers().size());
  std::vector<std::vector<Index>> faces(this->OfPeers.size());
  for (std::size_t q = 0; q < this->Quads.size(); ++q)
  {
    const Index id = idOf(this->Quads[q]);
    const Index3 cell = CellOfElement(mesh.Levels->Finest(), mesh, id);
    if (!this->Parts.OwnsCell(cell))
    {
      const int peer = this->Parts.PeerOfCell(cell);
      this->OfPeers[peer].push_back(static_cast<Index>(q));
      faces[peer].push_back(FaceOfId(id - TetIds.ElementSlots * this->Parts.NodeKeyShift(peer)));
    }
  }
  std::vector<Index> own;
  for (const Quad& quad : this->Quads)
  {
    own.push_back(FaceOfId(idOf(quad)));
  }
  this->ForPeers =
    MapLists(this->Parts.Exchange(faces), [&](Index face) { return FindSorted(own, face); });
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
      this->Active.Elements.begin() + 4 * (quad.First + t % (2 * quad.Sides)), 4, tets[t].begin());
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
    this->Energy.OfTets(corners, this->Active.WidthsAt(4 * quad.First), stage);
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
          other[t].begin(), other[t].end(), this->Active.Elements.begin() + 4 * (quad.First + t));
      }
      // Omits the centre, which is near points of ranks that do not have this quad.
      flipped.insert(flipped.end(), other[0].begin(), other[0].begin() + 3);
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
