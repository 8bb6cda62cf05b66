/**
 * AddLayers: layers along the interfaces and sides of the domain that the user selected.
 */
#pragma once

#include "Elements/MeshReport.h"
#include "Modify/CutLayers.h"
#include "Modify/MaterialPairs.h"
#include "Options/MesherOptions.h"

namespace vfm
{

/// The mesh that gets layers, and the interfaces that the user selected.
struct LayerInput
{
  double CellWidth;               ///< mean width of the finest cells
  Vector3 Periods;                ///< lengths after which the domain repeats; 0 along other axes
  const std::vector<int>& Labels; ///< ids of the user by material
  const MaterialPairs* Pairs;     ///< option LayerInterfaces; null: all interfaces
};

/// Cuts the hexahedra along interfaces, then those along each side of the domain, and measures the
/// mesh again. Does nothing without the option Layers.
/// @pre Collective
void AddLayers(const MesherOptions& options, const LayerInput& input, Runtime& runtime, Mesh& mesh,
  OutputState& state, MeshReport& report);

} // namespace vfm
