/**
 * SurfaceRuns: meshes from the fractions of bodies with their surfaces, on ranks.
 */
#pragma once

#include "Mesher.h"
#include "RankMeshes.h"

namespace vfm
{
namespace testing
{

/// Grid of cells of width 1 from the origin, and bodies.
struct SurfaceCase
{
  Index3 Cells;
  InputSurfaces Surfaces; ///< in axes of the grid
  ImageFrame Frame{};     ///< of the grid
};

/// Mesh of all ranks.
struct SurfaceMesh
{
  MergedMesh Merged;
  FieldArrays Fields;
  MeshReport Report;
};

/// Returns the part of a rank, a slab across z.
MesherInput MakeSurfaceInput(const SurfaceCase& c, Ranks& ranks);
SurfaceMesh MeshSurfaces(const SurfaceCase& c, const MesherOptions& options, int ranks = 1);

} // namespace testing
} // namespace vfm
