#include "Modify/AddLayers.h"

#include "Mesh/MeasureMaterials.h"
#include "Mesh/Quality.h"

namespace vfm
{
namespace
{

bool IsInterface(const MeshFacet& facet)
{
  return facet.DomainSide < 0;
}

/// Returns whether the user selected the interface of a facet, on the side of its element.
bool IsSelected(const Mesh& mesh, const MeshFacet& facet, const LayerChoice& choice, LayerSide side)
{
  const int own = choice.Labels[mesh.Material[facet.Element]];
  const int behind = choice.Labels[std::max(facet.Behind, 0)];
  return IsInterface(facet) &&
    (!choice.Pairs ||
      (side == LayerSide::First ? choice.Pairs->IsFirst(own, behind)
                                : choice.Pairs->Contains(own, behind)));
}

} // namespace

void AddLayers(const MesherOptions& options, const LayerChoice& choice, double width,
  Runtime& runtime, Mesh& mesh, OutputState& state, MeshReport& report)
{
  if (options.Layers < 2)
  {
    return;
  }
  const double unit = options.FirstLayerUnit == ThicknessUnit::Cells ? width : 1.0;
  const LayerSpacing spacing{ options.Layers, options.LayerGrowth, unit * options.FirstLayer };
  const auto isChosen = [&](const MeshFacet& facet)
  { return IsSelected(mesh, facet, choice, options.LayersOn); };
  CutLayers(
    FindLayerColumns(mesh, IsInterface, isChosen, runtime.Group()), spacing, runtime, mesh, state);
  for (int side = 0; side < 6; ++side)
  {
    const auto isOnSide = [side](const MeshFacet& facet) { return facet.DomainSide == side; };
    if ((options.LayerSides >> side / 2 & 1) != 0)
    {
      CutLayers(
        FindLayerColumns(mesh, isOnSide, isOnSide, runtime.Group()), spacing, runtime, mesh, state);
    }
  }
  if (options.ComputeQuality)
  {
    ComputeQuality(mesh, runtime, report);
  }
  MeasureMaterials(mesh, runtime.Group(), report);
}

} // namespace vfm
