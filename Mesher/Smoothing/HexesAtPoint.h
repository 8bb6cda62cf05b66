/**
 * HexesAtPoint: the hexes at a point in SIMD lanes of floats or doubles. Only HexEnergy.cxx
 * includes it.
 */
#pragma once

#include "Base/Lanes.h"
#include "Smoothing/ActiveMesh.h"

namespace vfm
{

constexpr double ShortestEdge = 0.15; // l*, in cell widths

struct BarrierWeights
{
  int HalfPower; // p / 2, a power of two
  double Target; // s*
  double Shape;  // omega
};

/// Hexes relative to a point, in right-handed axes, one per lane. Weights are 0 in unused lanes.
template <class Real>
struct Hexes
{
  using L = LanesOf<Real>;
  VectorLanes<Real> Arm[3];      // k: to the far end of the edge along axis k of the hex
  VectorLanes<Real> Diagonal[3]; // k: to the far corner of the face along axes k and k + 1
  L Target, Shape;               // s*^2; omega times the volume of the cell
  // 1 / width^2 and (l* width)^2 of the cell, per axis.
  L Scale[3], Edge[3];
  L InverseVolume; // inverse volume of the cell
};

/// Hexes at an active point relative to a position x, which may differ from its current position.
template <class Real>
class HexesAtPoint
{
public:
  VFM_INLINE HexesAtPoint(const ActiveMesh& mesh, int point, const Vector3& x) :
    TheMesh(mesh),
    Corners(mesh.CornerList.data() + mesh.CornerOffset[point]),
    Number(static_cast<int>(mesh.CornerOffset[point + 1] - mesh.CornerOffset[point])),
    List(mesh.Rings.HexesAt(point)),
    HasDemands(mesh.Rings.HasDemands(point))
  {
    const HexRings::Ring ring = mesh.Rings.PointsAt(point);
    for (int n = 0; n < ring.Near; ++n)
    {
      this->Around[n] = Difference<Real>(mesh.X[ring[n]], x);
    }
  }

  int Count() const { return this->Number; }
  VFM_INLINE Hexes<Real> Get(int first, const BarrierWeights& weights) const;

private:
  using L = LanesOf<Real>;
  static constexpr int Lanes = ElementLanes<Real>::Count;

  VFM_INLINE void SetCubes(Hexes<Real>& h, const L& isThere, const BarrierWeights& weights) const;
  VFM_INLINE void SetBoxes(
    Hexes<Real>& h, int first, const L& isThere, const BarrierWeights& weights) const;
  /// Returns the index of the hex in a lane; unused lanes repeat the last hex.
  int HexAt(int first, int lane) const { return std::min(first + lane, this->Number - 1); }

  const ActiveMesh& TheMesh;
  const CornerPosition* Corners;
  int Number;
  const HexRings::Hex* List;
  bool HasDemands;
  PointOf<Real> Around[HexRings::LargestRing];
};

template <class Real>
VFM_INLINE void HexesAtPoint<Real>::SetCubes(
  Hexes<Real>& h, const L& isThere, const BarrierWeights& weights) const
{
  const double width = this->TheMesh.Widths[0][0], volume = width * width * width;
  const double edge = ShortestEdge * width;
  for (int k = 0; k < 3; ++k)
  {
    h.Scale[k] = Fill<Real>(static_cast<Real>(1.0 / (width * width)));
    h.Edge[k] = isThere * static_cast<Real>(edge * edge);
  }
  h.InverseVolume = Fill<Real>(static_cast<Real>(1.0 / volume));
  h.Shape = isThere * static_cast<Real>(weights.Shape * volume);
}

template <class Real>
VFM_INLINE void HexesAtPoint<Real>::SetBoxes(
  Hexes<Real>& h, int first, const L& isThere, const BarrierWeights& weights) const
{
  for (int lane = 0; lane < Lanes; ++lane)
  {
    const int at = this->HexAt(first, lane);
    const Vector3& widths = this->TheMesh.WidthsAt(this->Corners[at]);
    const bool isExchanged = this->List[at].IsExchanged;
    const double volume = widths[0] * widths[1] * widths[2];
    for (int k = 0; k < 3; ++k)
    {
      const double width = widths[k < 2 && isExchanged ? 1 - k : k], edge = ShortestEdge * width;
      h.Scale[k][lane] = static_cast<Real>(1.0 / (width * width));
      h.Edge[k][lane] = isThere[lane] * static_cast<Real>(edge * edge);
    }
    h.InverseVolume[lane] = static_cast<Real>(1.0 / volume);
    h.Shape[lane] = isThere[lane] * static_cast<Real>(weights.Shape * volume);
  }
}

/// Returns one hex per lane, beginning with hex `first`.
template <class Real>
VFM_INLINE Hexes<Real> HexesAtPoint<Real>::Get(int first, const BarrierWeights& weights) const
{
  const HexRings::Hex* hexes[Lanes];
  for (int lane = 0; lane < Lanes; ++lane)
  {
    hexes[lane] = this->List + this->HexAt(first, lane);
  }
  const L isThere = FirstOnes<Real>(this->Number - first);
  Hexes<Real> h;
  for (int k = 0; k < 3; ++k)
  {
    h.Arm[k] = GatherPoints(this->Around, [&](int lane) { return hexes[lane]->Ends[k]; });
    h.Diagonal[k] = GatherPoints(this->Around, [&](int lane) { return hexes[lane]->Ends[3 + k]; });
  }
  h.Target = isThere * static_cast<Real>(weights.Target * weights.Target);
  for (int lane = 0; lane < Lanes && this->HasDemands; ++lane)
  {
    const Real demand =
      static_cast<Real>(this->TheMesh.DemandAt(this->Corners[this->HexAt(first, lane)]));
    h.Target[lane] *= demand * demand;
  }
  if (this->TheMesh.HasCubes())
  {
    this->SetCubes(h, isThere, weights);
  }
  else
  {
    this->SetBoxes(h, first, isThere, weights);
  }
  return h;
}

} // namespace vfm
