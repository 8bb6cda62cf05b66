#include "Phases/MeshOfCells.h"

#include "Phases/FinishMesh.h"
#include "Phases/FitElements.h"
#include "Phases/HexMethod.h"
#include "Phases/TetMethods.h"
#include "Ranks/Errors.h"

#include <sstream>
#include <stdexcept>

namespace vfm
{
namespace
{

void CheckRange(const char* name, double value, const NumberRange& range)
{
  if (!(value >= range.Least && value <= range.Most))
  {
    std::ostringstream text;
    text << name << " is " << value << ": it must lie in [" << range.Least << ", " << range.Most
         << "].";
    throw InputError(text.str());
  }
}

void CheckOptions(const MeshOptions& options)
{
  if (!(options.IsoValue > 0.0 && options.IsoValue < 1.0))
  {
    throw InputError("IsoValue is " + std::to_string(options.IsoValue) +
      ": it must lie between 0 and 1, both excluded.");
  }
  if (!(options.TargetScaledJacobian >= 0.0 && options.TargetScaledJacobian < 1.0))
  {
    throw InputError("TargetScaledJacobian is " + std::to_string(options.TargetScaledJacobian) +
      ": it must lie in [0, 1); 0 selects it automatically.");
  }
  CheckRange("LeastThickness", options.LeastThickness, LeastThicknesses);
  if (options.Levels.Refinements < 0 || options.Levels.FineLayers < 2)
  {
    throw InputError("FineLayers is " + std::to_string(options.Levels.FineLayers) +
      " and there are " + std::to_string(options.Levels.Refinements) +
      " refinements: at least 2 layers and 0 refinements are needed.");
  }
}

void CheckTetGenOptions(const MeshOptions& options)
{
  if (options.Method == TetMethod::TetGen && !HasTetGen())
  {
    throw InputError(
      "This build has no TetGen (VFM_ENABLE_TETGEN): choose the method Cells or Lattice.");
  }
  CheckRange("RelativeSize", options.RelativeSize, RelativeSizes);
  CheckRange("Growth", options.Growth, Growths);
  CheckRange("RadiusEdgeRatio", options.RadiusEdgeRatio, RadiusEdgeRatios);
  CheckRange("MinimumDihedralAngle", options.MinimumDihedralAngle, MinimumDihedralAngles);
  CheckRange("OptimizationLevel", options.OptimizationLevel, OptimizationLevels);
}

/// Returns whether the grid has at least the required ghost layers and exactly
/// the required hex layers.
bool HasLayers(const CartesianGrid& grid, const GridLayers& layers)
{
  const IndexBox needed = Grow(grid.Owned(), layers.Ghosts, grid.Global());
  return Intersect(needed, grid.Local()) == needed &&
    grid.HexBox() == Grow(grid.Owned(), layers.Hexes, grid.Global());
}

std::unique_ptr<ElementMethod> MakeTetMethod(const MeshCells& cells)
{
  if (cells.Options.Method == TetMethod::Lattice)
  {
    return std::make_unique<LatticeMethod>(cells);
  }
  return std::make_unique<CellsMethod>(cells);
}

/// The phases of every mesh.
Mesh MakeMesh(const MeshCells& cells, ElementMethod& method, MeshRun& run)
{
  Draft draft = method.Make(cells, run);
  if (MovesPoints(cells.Options))
  {
    FitElements(cells, method, run, draft);
  }
  return FinishMesh(cells, method, run, std::move(draft));
}

} // namespace

Mesh MakeHexMesh(const CartesianGrid& grid, const FractionField& fractions,
  const MeshOptions& options, Runtime& runtime, MeshReport& report)
{
  CheckOptions(options);
  report = MeshReport();
  if (!HasLayers(grid, LayersFor(options.Levels)))
  {
    throw std::logic_error("The grid has fewer ghost layers than LayersFor returns.");
  }
  const MeshCells cells{ grid, fractions, options };
  HexMethod method(cells);
  MeshRun run(grid, runtime, report);
  return MakeMesh(cells, method, run);
}

Mesh MakeTetMesh(const CartesianGrid& grid, const FractionField& fractions,
  const MeshOptions& options, Runtime& runtime, MeshReport& report)
{
  CheckOptions(options);
  CheckTetGenOptions(options);
  report = MeshReport();
  MeshOptions own = options;
  own.Levels.FineInterfaces = true; // tets support no other setting
  const MeshCells cells{ grid, fractions, own };
  const std::unique_ptr<ElementMethod> method = MakeTetMethod(cells);
  MeshRun run(grid, runtime, report);
  return MakeMesh(cells, *method, run);
}

bool HasTetGen()
{
#ifdef VFM_HAS_TETGEN
  return true;
#else
  return false;
#endif
}

} // namespace vfm
