/**
 * DiagonalFlips: flips diagonals of the quads of a Cells mesh, on interfaces and the domain
 * boundary, where that reduces the total energy of the tets on both sides. Quads share no tets, so
 * the result does not depend on their order, and all ranks that hold a quad make the same choice.
 * Copies of a quad on a periodic grid have the choice of its owner.
 * If a sharp edge runs across a quad from corner to corner, the diagonal follows it.
 */
#pragma once

#include "Elements/FeatureKind.h"
#include "Smoothing/Tet/ActiveTets.h"
#include "Smoothing/Tet/TetEnergy.h"

namespace vfm
{

/// Quads of an active mesh whose diagonals may be flipped. Changes only the tets of the active
/// mesh, until CopyTo.
class DiagonalFlips
{
public:
  /// Finds the quads.
  /// @param mesh  mesh of the active part; used only here
  /// @param partition,active,energy  must outlive this object
  /// @param kinds  one kind per point of the active mesh; must outlive this object
  /// @pre Collective among peers.
  DiagonalFlips(const Mesh& mesh, const BarrierElements& barrier, const Partition& partition,
    ActiveMesh& active, const TetEnergy& energy, const std::vector<FeatureKind>& kinds);

  /// Flips each quad once if this reduces its energy at a stage.
  /// @param changed  changed(point) is called for corners of a flipped quad. If interfaces cross
  ///   levels, it is called for all points of its tets, but not all ranks that have points around
  ///   these have the quad.
  /// @pre Collective among peers.
  void Run(const SmoothingStage& stage, const std::function<void(int)>& changed);

  /// Returns whether interfaces cross levels.
  bool CrossLevels() const { return this->Crossing; }

  /// Writes the tets back into the mesh.
  void CopyTo(Mesh& mesh) const;

private:
  struct Quad
  {
    std::array<Index, 4> Tets;     // two per side: (q0 q1 q2 c) and (q0 q2 q3 c)
    int Sides;                     // 1 on the domain boundary, 2 on interfaces
    std::array<bool, 2> IsBarrier; // whether the tets of each side are only a barrier
  };
  /// Halves of a quad at a side of a larger leaf: two tets, consecutive in the active mesh.
  struct LeafSide
  {
    Index Key;   // number of the side among those of all leaves
    Index First; // first tet
  };
  void FindFineQuads(const Mesh& mesh, const BarrierElements& barrier);
  void FindCoarseQuads(const Mesh& mesh, const BarrierElements& barrier);
  std::vector<LeafSide> ListLeafSides(const Mesh& mesh) const;
  void AddQuad(
    const std::array<Index, 4>& tets, int sides, const Mesh& mesh, const BarrierElements& barrier);
  void FindCopies(const Mesh& mesh);
  void TakeChoices(std::vector<unsigned char>& isBetter) const;
  using Tets = std::array<std::array<int, 4>, 4>;
  Tets TetsOf(const Quad& quad) const;
  static Tets Flipped(const Tets& tets);
  int CarriersOf(const Tets& tets) const;
  bool IsBetter(
    const Quad& quad, const Tets& tets, const Tets& other, const SmoothingStage& stage) const;
  double EnergyOf(const Quad& quad, const Tets& tets, const SmoothingStage& stage) const;

  const bool Crossing;
  const Partition& Parts;
  ActiveMesh& Active;
  const TetEnergy& Energy;
  const std::vector<FeatureKind>& Kinds;
  std::vector<Quad> Quads;
  // Quads that each peer owns, and quads that each peer requests; empty if the grid is not
  // periodic.
  std::vector<std::vector<Index>> OfPeers, ForPeers;
};

} // namespace vfm
