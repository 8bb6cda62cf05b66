/**
 * The diagonals of the quads on interfaces and sides of the domain of a Cells mesh: flipped where that lowers the energy of the
 * tets at the quad, both sides together. Quads do not share tets, so the result depends on no order, and all ranks
 * that hold a quad decide alike. Where an edge of the interface runs across a quad, from corner to corner, the diagonal does too.
 */
#pragma once

#include "Mesh/FeatureKind.h"
#include "Smoothing/TetEnergy.h"
#include "Tet/ActiveTets.h"

namespace vfm
{

class DiagonalFlips
{
public:
  /// kinds: of the points of the active mesh. Keeps references to all but the mesh.
  DiagonalFlips(const Mesh& mesh, ActiveTets& active, const TetEnergy& energy,
    const std::vector<FeatureKind>& kinds);

  /// Flips what should be; calls changed(point) for every point of a flipped quad.
  void Run(const SmoothingStage& stage, const std::function<void(int)>& changed);

  /// Writes the tets back into the mesh.
  void CopyTo(Mesh& mesh) const;

private:
  struct Quad
  {
    Index First; // tet; two a side
    int Sides;
  };
  using Tets = std::array<std::array<int, 4>, 4>;
  Tets TetsOf(const Quad& quad) const;
  static Tets Flipped(const Tets& tets);
  int CarriersOf(const Tets& tets) const;
  bool IsBetter(
    const Quad& quad, const Tets& tets, const Tets& other, const SmoothingStage& stage) const;
  double EnergyOf(const Quad& quad, const Tets& tets, const SmoothingStage& stage) const;

  ActiveTets& Active;
  const TetEnergy& Energy;
  const std::vector<FeatureKind>& Kinds;
  std::vector<Quad> Quads;
};

} // namespace vfm
