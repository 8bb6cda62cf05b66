/**
 * MeshRun: what all stages between cells and mesh read and report to.
 */
#pragma once

#include "Base/Options.h"
#include "Base/Partition.h"
#include "Elements/StageClock.h"
#include "Fractions/FractionField.h"

namespace vfm
{

class BodySurfaces;
struct CellRuns;

/// Cells to mesh. The referenced objects must outlive it.
struct MeshCells
{
  const CartesianGrid& Grid; ///< finest cells
  const FractionField& Fractions;
  const MeshOptions& Options;
  const BodySurfaces* Surfaces = nullptr; ///< of the fractions; null: they are not known
  CellRuns* Runs = nullptr; ///< receives hexes that the mesh leaves out; null: it has all hexes
  int FlatAxis = -1; ///< axis of one cell along which points are in straight columns; -1: none
  /// Whether the hexes of these columns are to be divided into triangles.
  bool AreTriangles = false;
};

/// Threads, ranks and report of a run. The referenced objects must outlive it.
struct MeshRun
{
  MeshRun(const CartesianGrid& grid, Runtime& runtime, MeshReport& report) :
    TheRuntime(runtime), Report(report), Clock(runtime, report), Parts(grid, runtime.Group())
  {
  }
  Ranks& Group() { return this->TheRuntime.Group(); }

  Runtime& TheRuntime;
  MeshReport& Report;
  StageClock Clock;
  const Partition Parts;
};

} // namespace vfm
