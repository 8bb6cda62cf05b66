/**
 * TetMethods: how tetrahedra are made and moved. LatticeMethod and CellsMethod differ in the tets
 * and in their fragments; TetMethodBase is what they have in common.
 */
#pragma once

#include "Elements/Tet/LatticeNodes.h"
#include "Elements/Tet/TetFacets.h"
#include "Labels/NarrowVoid.h"
#include "Phases/ElementMethod.h"
#include "Smoothing/Tet/ActiveTets.h"
#include "Smoothing/Tet/DiagonalFlips.h"

#include <optional>

namespace vfm
{

class CoarseTets;

class TetMethodBase : public ElementMethod
{
public:
  explicit TetMethodBase(const MeshCells& cells);

  Draft Make(const MeshCells& cells, MeshRun& run) override;
  ActiveMesh& MakeActive(const MeshCells& cells, MeshRun& run, Draft& draft) override;
  std::unique_ptr<LevelInterfaces> FindInterfaces(
    const MeshCells& cells, const Draft& draft, MeshRun& run) override;
  void Attach(const LevelInterfaces& interfaces, const Draft& draft, MeshRun& run) override;
  const ElementEnergy& Energy() const override { return this->TheEnergy; }
  SmoothingRamp Ramp(const MeshCells& cells) const override;
  void StartMoves(const MeshCells& cells, const std::vector<FeatureKind>& kinds, MeshRun& run,
    Draft& draft) override;
  void RestoreDraft(const MeshCells& cells, MeshRun& run, Draft& draft) override;
  void EndMoves(MeshRun& run, Draft& draft) override;

protected:
  /// Makes what the functions below need besides the labels.
  virtual void StartTets(const MeshCells&, MeshRun&) {}
  /// Returns the nodes around which all cells must be finest ones, ascending.
  virtual std::vector<Index> FindCrossedNodes(const MeshCells& cells) const = 0;
  /// Makes the tets, and sets Faces.
  /// @param narrow  void cells that get tets as a barrier
  virtual TetTopology BuildTets(
    const MeshCells& cells, const NarrowVoid& narrow, const CoarseTets& coarse, MeshRun& run) = 0;
  /// Finds the fragments and their volumes, and fills the fragments of the tets.
  virtual FragmentVolumes FindFragments(
    const MeshCells& cells, MeshRun& run, TetTopology& topology) = 0;

  const TetMethod Kind;
  TetEnergy TheEnergy;
  LabelArray Labels;
  std::vector<Index> Thin;  // ResolvedCells::Thin
  std::vector<Index> Mixed; // FindMixedNodes
  std::vector<PointPosition> Positions;
  TetFaces Faces;
  ActiveMesh Active;

private:
  std::shared_ptr<const RefinedGrid> LabelCells(
    const MeshCells& cells, MeshRun& run, NarrowVoid& narrow);
  std::shared_ptr<const RefinedGrid> LabelLeaves(
    const MeshCells& cells, MeshRun& run, NarrowVoid& narrow);
};

/// Tets of the method Lattice, cut where the labels of lattice nodes differ.
class LatticeMethod : public TetMethodBase
{
public:
  using TetMethodBase::TetMethodBase;

private:
  void StartTets(const MeshCells& cells, MeshRun& run) override;
  std::vector<Index> FindCrossedNodes(const MeshCells& cells) const override;
  TetTopology BuildTets(const MeshCells& cells, const NarrowVoid& narrow, const CoarseTets& coarse,
    MeshRun& run) override;
  FragmentVolumes FindFragments(
    const MeshCells& cells, MeshRun& run, TetTopology& topology) override;

  std::optional<LatticeNodes> Nodes; // until the tets are built
};

/// Tets of the method Cells, whose diagonals on interfaces are flipped while points move; TetGen
/// replaces them at the end, if the options request it.
class CellsMethod : public TetMethodBase
{
public:
  using TetMethodBase::TetMethodBase;

  std::vector<Facet> FeatureFacets(const MeshCells& cells, const Draft& draft) const override;
  void StartMoves(const MeshCells& cells, const std::vector<FeatureKind>& kinds, MeshRun& run,
    Draft& draft) override;
  bool ChangesElements() const override { return true; }
  void AfterSweep(const SmoothingStage& stage, int sweep, Smoother& smoother) override;
  void AfterRamp(const MeshCells& cells, MeshRun& run, Draft& draft) override;
  void EndMoves(MeshRun& run, Draft& draft) override;
  void Refill(const MeshCells& cells, MeshRun& run, Mesh& mesh) override;

private:
  std::vector<Index> FindCrossedNodes(const MeshCells& cells) const override;
  TetTopology BuildTets(const MeshCells& cells, const NarrowVoid& narrow, const CoarseTets& coarse,
    MeshRun& run) override;
  FragmentVolumes FindFragments(
    const MeshCells& cells, MeshRun& run, TetTopology& topology) override;

  std::optional<DiagonalFlips> Flips; // while points move
};

} // namespace vfm
