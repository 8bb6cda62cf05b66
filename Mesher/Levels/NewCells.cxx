#include "Levels/NewCells.h"

#include "Fractions/GhostFractions.h"
#include "Levels/FitWidths.h"
#include "Levels/HalvedCells.h"
#include "Levels/PeriodicFields.h"
#include "Levels/WideCells.h"
#include "Options/CellWidths.h"
#include "Options/MaterialWidths.h"

#include <cmath>

namespace vfm
{
namespace
{

// Widest automatic cells, in cells of the input: without and with CellWidth.
constexpr double WidestCells = 4.0, WidestOfAll = 16.0;

/// Returns the limits of automatic widths.
/// @param widest largest widths; 0: WidestCells
WidthLimits LimitsOf(const MesherOptions& options, const GridNodes& nodes, const Vector3& widest)
{
  const Vector3 ofInput = MeanWidths(nodes);
  double ratio = widest == Vector3{} ? WidestCells : WidestOfAll;
  for (int a = 0; a < 3; ++a)
  {
    ratio = widest[a] > 0.0 ? std::min(ratio, widest[a] / ofInput[a]) : ratio;
  }
  return { ratio, options.AllowedError,
    UsesTetGen(options) ? 0 : CountDoublings(nodes, RepeatingAxes(options)) };
}

/// Collective. Plans cells that are as wide as the materials allow.
CellSizes FitSizes(
  const MesherOptions& options, const LevelFields& fields, const Vector3& widest, Runtime& runtime)
{
  const GridNodes& nodes = fields.Grid.Coordinates();
  const WidthLimits limits = LimitsOf(options, nodes, widest);
  LevelFields held = fields;
  WidenGrid({ LayersOf(limits), HexLayers }, runtime.Group(), held.Grid, held.Field.Fractions);
  const FractionField& fractions = held.Field.Fractions;
  const LabelArray labels = AssignMaterials(held.Grid, fractions, options.IsoValue);
  const std::vector<FittedWidth> fitted =
    FitWidths(held.Grid, fractions, labels, limits, options.IsoValue, runtime);
  WidthChoice choice = ChooseWidths(held.Grid, labels, fitted, limits, runtime.Group());
  Vector3 finest = MeanWidths(nodes);
  for (double& width : finest)
  {
    width *= std::ldexp(choice.Coarsest, -choice.Halvings);
  }
  const std::array<bool, 3> repeats = RepeatingAxes(options);
  const int halvings = LimitHalvings(nodes, finest, choice.Halvings, repeats);
  for (int& own : choice.OfMaterial)
  {
    own = std::max(own - (choice.Halvings - halvings), 0);
  }
  return { PlaceNodes(nodes, finest, halvings, repeats), halvings, std::move(choice.OfMaterial) };
}

LevelSetup DecideLevels(
  const MesherOptions& options, const GridNodes& nodes, const InputRequests& requests)
{
  return DecideLevels(options.Refinement, options.MaximumLevel, nodes, 0,
    CountPeriodicLevels(options, nodes), requests.Finest);
}

} // namespace

bool ReplacesCells(const MesherOptions& options)
{
  return HasCellWidth(options) || HasMaterialWidths(options);
}

void CheckMaterialWidths(const MesherOptions& options)
{
  if (HasMaterialWidths(options) && options.Refinement != RefinementMode::InputLevels &&
    options.Refinement != RefinementMode::Off)
  {
    throw InputError("MaterialWidths cannot be combined with Refinement Automatic, Coarsen or "
                     "Uniform: it determines the levels of the mesh itself.");
  }
}

CellSizes PlanNewCells(const MesherOptions& options, const LevelFields& fields,
  const std::vector<Index>& cells, Runtime& runtime)
{
  const GridNodes& nodes = fields.Grid.Coordinates();
  const Vector3 widths = *ParseWidths(options.CellWidth);
  const MaterialWidths ofMaterials = *ParseMaterialWidths(options.MaterialWidths);
  if (ofMaterials.IsAutomatic)
  {
    return FitSizes(options, fields, widths, runtime);
  }
  if (ofMaterials.IsUsed())
  {
    const Materials& table = fields.Field.Table;
    return PlanSizes(nodes, widths, FindWidths(ofMaterials, NamesOf(table), table.Labels, cells),
      RepeatingAxes(options));
  }
  CellSizes sizes;
  sizes.Nodes = ReplaceNodes(nodes, widths);
  sizes.Halvings = std::max(-DecideLevels(options, sizes.Nodes, InputRequests()).Base, 0);
  return sizes;
}

/// Automatic widths fit the surfaces; other widths are also those of the cells around.
LevelSetup SetUpNewLevels(const MesherOptions& options, const CellSizes& sizes,
  const InputRequests& requests, LevelFields& fields)
{
  if (sizes.OfMaterial.empty())
  {
    return DecideLevels(options, sizes.Nodes, requests);
  }
  const Index layers = ParseMaterialWidths(options.MaterialWidths)->IsAutomatic ? 0 : 1;
  const HalvedCells halved =
    FindHalved(fields.Grid, fields.Field.Fractions, sizes.OfMaterial, sizes.Halvings);
  fields.Families = FamiliesOf(halved, fields.Base, RepeatingAxes(options), layers);
  LevelSetup setup;
  setup.Base = -sizes.Halvings;
  setup.TakesInputLevels = true;
  return setup;
}

} // namespace vfm
