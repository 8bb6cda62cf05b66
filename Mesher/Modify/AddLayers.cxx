#include "Modify/AddLayers.h"

#include "Geometry/MeasureMaterials.h"
#include "Geometry/Quality.h"
#include "Report/Sets/MaterialsBehind.h"

namespace vfm
{
namespace
{

/// Returns whether the user selected the interface between an element and a material behind it.
bool IsSelected(const LayerInput& input, LayerSide side, int own, int behind)
{
  const int first = input.Labels[own], second = input.Labels[behind];
  return !input.Pairs ||
    (side == LayerSide::First ? input.Pairs->IsFirst(first, second)
                              : input.Pairs->Contains(first, second));
}

/// Collective. Returns the facets between materials or at void, also those between opposite sides
/// of a periodic domain.
std::vector<ColumnBase> ListInterfaces(
  const MesherOptions& options, const LayerInput& input, const Mesh& mesh, Ranks& ranks)
{
  const std::vector<Index> materials = FindMaterialsBehind(ViewMesh(mesh), ranks);
  std::vector<ColumnBase> bases;
  for (std::size_t f = 0; f < materials.size(); ++f)
  {
    const MeshFacet& facet = mesh.Facets[f];
    const int own = mesh.Material[facet.Element];
    const int behind = std::max(static_cast<int>(materials[f]), 0);
    const bool isAcross = materials[f] != NothingBehind && behind != own;
    if (facet.DomainSide < 0 || isAcross)
    {
      bases.push_back(
        { facet.Element, facet.Side, IsSelected(input, options.LayersOn, own, behind) });
    }
  }
  return bases;
}

/// Returns the facets on a side of the domain.
std::vector<ColumnBase> ListSide(const Mesh& mesh, int side)
{
  std::vector<ColumnBase> bases;
  for (const MeshFacet& facet : mesh.Facets)
  {
    if (facet.DomainSide == side)
    {
      bases.push_back({ facet.Element, facet.Side, true });
    }
  }
  return bases;
}

} // namespace

void AddLayers(const MesherOptions& options, const LayerInput& input, Runtime& runtime, Mesh& mesh,
  OutputState& state, MeshReport& report)
{
  if (options.Layers < 2)
  {
    return;
  }
  const bool isInCells = options.FirstLayerUnit == ThicknessUnit::Cells;
  const LayerSpacing spacing{ options.Layers, options.LayerGrowth,
    options.FirstLayer * (isInCells ? input.CellWidth : 1.0) };
  const auto cut = [&](const std::vector<ColumnBase>& bases)
  {
    CutLayers(
      FindLayerColumns(mesh, bases, runtime.Group()), spacing, input.Periods, runtime, mesh, state);
  };
  cut(ListInterfaces(options, input, mesh, runtime.Group()));
  for (int side = 0; side < 6; ++side)
  {
    if ((options.LayerSides >> side / 2 & 1) != 0)
    {
      cut(ListSide(mesh, side));
    }
  }
  if (options.ComputeQuality)
  {
    ComputeQuality(mesh, runtime, report);
  }
  MeasureMaterials(mesh, runtime.Group(), report);
}

} // namespace vfm
