/**
 * ElementMethod: what hexahedra (HexMethod) and the methods of tetrahedra (TetMethods) do
 * differently. MeshOfCells and FitElements call the functions in the order in which they stand
 * here, once a run, except AfterSweep.
 */
#pragma once

#include "Elements/MeshRun.h"
#include "Interface/LevelInterfaces.h"
#include "Phases/Draft.h"
#include "Smoothing/Smoother.h"

#include <memory>

namespace vfm
{

/// A method keeps what it needs between its calls. All functions are collective.
class ElementMethod
{
public:
  virtual ~ElementMethod() = default;

  /// Makes valid elements in their first position, with their fragments, facets and the volumes
  /// that the fragments must have.
  virtual Draft Make(const MeshCells& cells, MeshRun& run) = 0;

  /// Returns the part of the mesh that moves; it lives until EndMoves.
  virtual ActiveMesh& MakeActive(const MeshCells& cells, MeshRun& run, Draft& draft) = 0;
  /// Returns the interfaces of the labels. Frees what only interfaces need.
  virtual std::unique_ptr<LevelInterfaces> FindInterfaces(
    const MeshCells& cells, const Draft& draft, MeshRun& run) = 0;
  /// Attaches the active points on interfaces to their targets.
  virtual void Attach(const LevelInterfaces& interfaces, const Draft& draft, MeshRun& run) = 0;
  /// Returns the facets whose edges may be sharp, if they are others than those of the draft.
  virtual std::vector<Facet> FeatureFacets(const MeshCells&, const Draft&) const { return {}; }

  /// Returns the energy of the elements, and the ramp of its stages.
  virtual const ElementEnergy& Energy() const = 0;
  virtual SmoothingRamp Ramp(const MeshCells& cells) const = 0;
  /// Frees or packs what nothing reads while points move.
  /// @param kinds  of the active points; must live until EndMoves
  virtual void StartMoves(
    const MeshCells& cells, const std::vector<FeatureKind>& kinds, MeshRun& run, Draft& draft) = 0;
  /// Returns whether elements change between sweeps, so that AfterSweep and AfterRamp are called.
  virtual bool ChangesElements() const { return false; }
  /// @param sweep  number of the sweep in the stage, from 0
  virtual void AfterSweep(const SmoothingStage&, int sweep, Smoother&) { (void)sweep; }
  /// Replaces the facets of the draft and of the active mesh.
  virtual void AfterRamp(const MeshCells&, MeshRun&, Draft&) {}
  /// Undoes StartMoves; the active mesh stays. Packed facets come back in EndMoves.
  virtual void RestoreDraft(const MeshCells& cells, MeshRun& run, Draft& draft) = 0;
  /// Frees the active mesh. Then moves points that are far from interfaces, if the method needs
  /// that.
  virtual void EndMoves(MeshRun& run, Draft& draft) = 0;

  /// Replaces the elements of a mesh with geometry, within its surfaces.
  /// @param mesh  has only the elements that this rank owns
  virtual void Refill(const MeshCells&, MeshRun&, Mesh& mesh) { (void)mesh; }
};

} // namespace vfm
