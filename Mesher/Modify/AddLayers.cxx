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
bool IsSelected(const Mesh& mesh, const MeshFacet& facet, const LayerInput& input, LayerSide side)
{
  const int own = input.Labels[mesh.Material[facet.Element]];
  const int behind = input.Labels[std::max(facet.Behind, 0)];
  return IsInterface(facet) &&
    (!input.Pairs ||
      (side == LayerSide::First ? input.Pairs->IsFirst(own, behind)
                                : input.Pairs->Contains(own, behind)));
}

/// Returns the lengths after which the domain repeats; 0 along other axes.
Vector3 FindPeriods(const MesherOptions& options, const CartesianGrid& grid)
{
  Vector3 periods{};
  for (int a = 0; a < 3; ++a)
  {
    const std::vector<double>& x = grid.Coordinates(a);
    periods[a] = RepeatingAxes(options)[a] ? x.back() - x.front() : 0.0;
  }
  return periods;
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
    options.FirstLayer * (isInCells ? input.Grid.MeanWidth() : 1.0) };
  const Vector3 periods = FindPeriods(options, input.Grid);
  const auto cut = [&](const auto& isOnSurface, const auto& isChosen)
  {
    CutLayers(FindLayerColumns(mesh, isOnSurface, isChosen, runtime.Group()), spacing, periods,
      runtime, mesh, state);
  };
  cut(IsInterface,
    [&](const MeshFacet& facet) { return IsSelected(mesh, facet, input, options.LayersOn); });
  for (int side = 0; side < 6; ++side)
  {
    const auto isOnSide = [side](const MeshFacet& facet) { return facet.DomainSide == side; };
    if ((options.LayerSides >> side / 2 & 1) != 0)
    {
      cut(isOnSide, isOnSide);
    }
  }
  if (options.ComputeQuality)
  {
    ComputeQuality(mesh, runtime, report);
  }
  MeasureMaterials(mesh, runtime.Group(), report);
}

} // namespace vfm
