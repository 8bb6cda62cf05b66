/**
 * HexMethod: how hexahedra are made and moved.
 */
#pragma once

#include "Elements/Hex/LabelledGrid.h"
#include "Phases/ElementMethod.h"
#include "Smoothing/Hex/ActiveCorners.h"
#include "Smoothing/Hex/FlatDiagonals.h"
#include "Smoothing/Hex/HexEnergy.h"
#include "Smoothing/Hex/PackedLists.h"

#include <optional>

namespace vfm
{

class HexMethod : public ElementMethod
{
public:
  explicit HexMethod(const MeshCells& cells);

  Draft Make(const MeshCells& cells, MeshRun& run) override;
  ActiveMesh& MakeActive(const MeshCells& cells, MeshRun& run, Draft& draft) override;
  std::unique_ptr<LevelInterfaces> FindInterfaces(
    const MeshCells& cells, const Draft& draft, MeshRun& run) override;
  void Attach(const LevelInterfaces& interfaces, const Draft& draft, MeshRun& run) override;
  const ElementEnergy& Energy() const override { return *this->TheEnergy; }
  SmoothingRamp Ramp(const MeshCells& cells) const override;
  void StartMoves(const MeshCells& cells, const std::vector<FeatureKind>& kinds, MeshRun& run,
    Draft& draft) override;
  void AfterSweep(const SmoothingStage& stage, int sweep, Smoother& smoother) override;
  void RestoreDraft(const MeshCells& cells, MeshRun& run, Draft& draft) override;
  void EndMoves(MeshRun& run, Draft& draft) override;

private:
  int FlatAxis;                           // MeshCells::FlatAxis
  std::optional<FlatDiagonals> Diagonals; // of triangles
  std::unique_ptr<const ElementEnergy> TheEnergy;
  LabelledGrid Labelled;
  ActiveMesh Active;
  std::optional<ActiveCorners> Corners; // of the draft while points move
  // Of the draft while points move.
  std::optional<PackedMesh> Packed;
  std::optional<PackedArray<Index>> PointIds;
  std::optional<PackedFacets> Facets;
};

} // namespace vfm
