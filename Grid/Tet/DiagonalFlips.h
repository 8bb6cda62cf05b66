/**
 * The diagonals of the quads on interfaces and sides of the domain of a Cells mesh: flipped where that lowers the energy of the
 * tets at the quad, both sides together. Quads do not share tets, so the result depends on no order, and all ranks
 * that hold a quad decide alike.
 */
#pragma once

#include "Smoothing/TetEnergy.h"
#include "Tet/ActiveTets.h"

namespace vfm
{

class DiagonalFlips
{
public:
  DiagonalFlips(const Mesh& mesh, ActiveTets& active, const TetEnergy& energy);

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
  double EnergyOf(const Quad& quad, const Tets& tets, const SmoothingStage& stage) const;

  ActiveTets& Active;
  const TetEnergy& Energy;
  std::vector<Quad> Quads;
};

} // namespace vfm
