#include "Phases/MeshOfCells.h"

#include "Options/SetOptions.h"
#include "Phases/FinishMesh.h"
#include "Phases/FitElements.h"
#include "Phases/HexMethod.h"
#include "Phases/TetMethods.h"

#include <stdexcept>

namespace vfm
{
namespace
{

void CheckOptions(const MeshOptions& options, ElementKind elements)
{
  MesherOptions all;
  static_cast<MeshSettings&>(all) = options;
  static_cast<LevelSettings&>(all) = options.Levels;
  all.Elements = elements;
  CheckOptions(all);
  if (options.Levels.Refinements < 0)
  {
    throw InputError(
      "Refinements is " + std::to_string(options.Levels.Refinements) + ": it must be at least 0.");
  }
}

/// Checks that the grid has at least the required ghost layers and exactly the required hex layers.
void CheckLayers(const CartesianGrid& grid, const LevelPlan& plan)
{
  const GridLayers layers = LayersFor(plan);
  const IndexBox needed = Grow(grid.Owned(), layers.Ghosts, grid.Global());
  if (Intersect(needed, grid.Local()) != needed ||
    grid.HexBox() != Grow(grid.Owned(), layers.Hexes, grid.Global()))
  {
    throw std::logic_error("The grid has fewer ghost layers than LayersFor returns.");
  }
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

Mesh MakeHexes(const MeshCells& cells, Runtime& runtime, MeshReport& report)
{
  CheckLayers(cells.Grid, cells.Options.Levels);
  HexMethod method(cells);
  MeshRun run(cells.Grid, runtime, report);
  return MakeMesh(cells, method, run);
}

/// Returns the options with which tets are made.
MeshOptions OptionsOfTets(const MeshCells& cells)
{
  MeshOptions own = cells.Options;
  if (own.Method == TetMethod::TetGen)
  {
    own.Levels.FineInterfaces = true; // it supports no other setting
  }
  else if (InterfacesCrossLevels(own))
  {
    own.Method = TetMethod::Cells; // labels belong to leaves
    CheckLayers(cells.Grid, own.Levels);
  }
  return own;
}

Mesh MakeTets(const MeshCells& given, Runtime& runtime, MeshReport& report)
{
  if (given.Options.Method == TetMethod::TetGen && !HasTetGen())
  {
    throw InputError(
      "This build has no TetGen (VFM_ENABLE_TETGEN): choose the method Cells or Lattice.");
  }
  const MeshOptions options = OptionsOfTets(given);
  const MeshCells cells{ given.Grid, given.Fractions, options, given.Surfaces };
  const std::unique_ptr<ElementMethod> method = MakeTetMethod(cells);
  MeshRun run(cells.Grid, runtime, report);
  return MakeMesh(cells, *method, run);
}

} // namespace

Mesh MakeMeshOfCells(
  ElementKind elements, const MeshCells& cells, Runtime& runtime, MeshReport& report)
{
  CheckOptions(cells.Options, elements);
  report = MeshReport();
  return elements == ElementKind::Hexes ? MakeHexes(cells, runtime, report)
                                        : MakeTets(cells, runtime, report);
}

Mesh MakeHexMesh(const CartesianGrid& grid, const FractionField& fractions,
  const MeshOptions& options, Runtime& runtime, MeshReport& report)
{
  return MakeMeshOfCells(ElementKind::Hexes, { grid, fractions, options }, runtime, report);
}

Mesh MakeTetMesh(const CartesianGrid& grid, const FractionField& fractions,
  const MeshOptions& options, Runtime& runtime, MeshReport& report)
{
  return MakeMeshOfCells(ElementKind::Tets, { grid, fractions, options }, runtime, report);
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
