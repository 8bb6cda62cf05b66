/**
 * Options of the pipelines MakeHexMesh, MakeTetMesh and of their stages.
 */
#pragma once

#include "Base/CartesianGrid.h"

#include <vector>

namespace vfm
{

/// Placement of surface nodes.
enum class SmoothingMethod
{
  Off,            ///< valid start positions: the stair-step interface with a thin buffer layer
  QuadricSurface, ///< barrier energy, surface nodes attracted to local quadrics of the interface
  GeometryBased   ///< barrier energy, surface nodes kept on the facets of the unsmoothed interface
};

/// Detection of sharp features, the edges and corners of interfaces, which the mesh then preserves.
enum class SharpEdgeMode
{
  Off,
  On,
  Automatic ///< only between pairs of materials whose samples show edges (SharpPairs.h)
};

/// Method that makes tetrahedra.
enum class TetMethod
{
  TetGen, ///< the smoothed interfaces of Cells as constrained surfaces, filled by TetGen
  Cells,  ///< a body-centred lattice of the cells; the hex mesh has the same interfaces
  Lattice ///< a body-centred lattice of cell centres and nodes, cut where labels differ
};

/// Order of the elements.
enum class InterpolationOrder
{
  Linear,
  Quadratic,  ///< hexahedra of 20 nodes, tetrahedra of 10
  Quadratic27 ///< hexahedra of 27 nodes, tetrahedra of 10
};

/// Range of an option, limits included.
struct NumberRange
{
  double Least, Most;
};

constexpr NumberRange LeastThicknesses{ 0.0, 1.0 }, RelativeSizes{ 0.1, 1e6 }, Growths{ 0.0, 1e6 },
  RadiusEdgeRatios{ 1.0, 100.0 }, MinimumDihedralAngles{ 0.0, 60.0 }, OptimizationLevels{ 0, 10 },
  EdgeAngles{ 1.0, 179.0 };

/// Options of TetGen.
struct TetGenOptions
{
  double RelativeSize = 1.0;          ///< edge length at the interfaces, in cells
  double Growth = 0.3;                ///< increase of the length per cell of distance from them
  double RadiusEdgeRatio = 1.4;       ///< maximum ratio of circumradius and shortest edge
  double MinimumDihedralAngle = 10.0; ///< target of refinement, degrees
  int OptimizationLevel = 4;          ///< level of TetGen's flips and smoothing
};

/// User options of a refined grid.
struct LevelSettings
{
  /// true: all interfaces get cells of the finest level. false: only cells of Families do, so
  /// interfaces cross levels, except those of TetGen.
  bool FineInterfaces = true;
  /// Number of layers of finest cells around the finest cells at interfaces; tets have fewer.
  int FineLayers = 2;
};

/// What is refined: families of 2x2x2 cells, or for tets single cells (OctantFamilies.h).
enum class RefinedUnit
{
  Family,
  Cell
};

/// Plan of a refined grid: which cells may be coarser than the cells of the grid given to the
/// pipelines (RefinedGrid.h).
struct LevelPlan : LevelSettings
{
  int Refinements = 0; ///< base cells are 2^Refinements cells of the grid along each axis
  /// Additional families to refine: for each refinement the keys of the families owned by this rank
  /// (OctreeKeys::FamilyKey); of cells, if these are the unit (OctantFamilies).
  std::vector<std::vector<Index>> Families;
  RefinedUnit Unit = RefinedUnit::Family;
};

/// User options of the pipelines.
struct MeshSettings : TetGenOptions
{
  double IsoValue = 0.5; ///< limit of void, in (0,1): a cell is void if its materials fill less
  bool MeshVoid = false; ///< true: void is meshed as material 0
  bool ThinParts =
    false; ///< films, threads and drops get cells (ThinParts.h); only at IsoValue 0.5
  double LeastThickness = 0.25; ///< of thin parts, in cells
  bool StairStep = false;       ///< true: cells become hexes; nothing is inserted or moved
  SmoothingMethod Smoothing = SmoothingMethod::QuadricSurface;
  /// Weight of quality against distance, in [0,1). 0 selects 0.55 for one
  /// material, 0.5 for several.
  double TargetScaledJacobian = 0.0;
  SharpEdgeMode SharpEdges =
    SharpEdgeMode::Off; ///< only with IsoValue 0.5 and SmoothingMethod::QuadricSurface
  /// Surfaces of the input attract points; only with IsoValue 0.5 and
  /// SmoothingMethod::QuadricSurface.
  bool UseSurfaces = true;
  double EdgeAngle = 40.0;    ///< least angle of sharp edges of surfaces of the input, degrees
  bool ConserveVolume = true; ///< match the fractions' volumes; only with IsoValue 0.5
  bool ComputeQuality = true; ///< fill Mesh::ScaledJacobian
  TetMethod Method = TetMethod::Lattice; ///< method of tetrahedral meshes
  InterpolationOrder ElementOrder = InterpolationOrder::Linear;
};

/// All options of a pipeline.
struct MeshOptions : MeshSettings
{
  LevelPlan Levels;
  /// true: the volumes of fragments do not count material that has no cell of its label around;
  /// Mesh::Far lists it.
  bool LeavesFar = false;
};

/// Returns whether interfaces may run through cells of several levels.
inline bool InterfacesCrossLevels(const LevelPlan& levels)
{
  return levels.Refinements > 0 && !levels.FineInterfaces;
}
inline bool InterfacesCrossLevels(const MeshOptions& options)
{
  return InterfacesCrossLevels(options.Levels);
}

/// Returns whether thin parts get cells.
inline bool KeepsThinParts(const MeshSettings& options)
{
  return options.ThinParts && options.IsoValue == 0.5;
}

/// Returns whether points move from where the cells place them.
inline bool MovesPoints(const MeshSettings& options)
{
  return !options.StairStep && options.Smoothing != SmoothingMethod::Off;
}

/// Returns whether a mesh whose points move gets the volumes of the fractions.
inline bool ConservesVolume(const MeshSettings& options)
{
  return options.ConserveVolume && options.IsoValue == 0.5;
}

/// Numbers of layers of cells around the owned cells.
struct GridLayers
{
  int Ghosts = GhostLayers; ///< layers that the rank holds
  int Hexes = HexLayers;    ///< innermost of these layers, which the rank meshes too
};

/// Returns the numbers of layers that a mesh needs. If interfaces cross levels, they are
/// multiplied by the width of a base cell: points that move with a base node belong to hexes up to
/// a base cell away.
inline GridLayers LayersFor(const LevelPlan& levels)
{
  GridLayers layers;
  if (InterfacesCrossLevels(levels))
  {
    layers.Ghosts = GhostLayers << levels.Refinements;
    layers.Hexes = std::max(HexLayers, 1 << levels.Refinements);
  }
  return layers;
}

} // namespace vfm
