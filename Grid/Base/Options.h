/**
 * What the pipelines are asked for.
 */
#pragma once

#include "Base/CartesianGrid.h"

#include <vector>

namespace vfm
{

/// How surface nodes are placed.
enum class Smoothing
{
  Off,            ///< valid start positions: the stair-step interface with a thin buffer layer
  QuadricSurface, ///< barrier energy, surface nodes drawn to local quadrics of the true interface
  GeometryBased   ///< barrier energy, surface nodes kept on the facets of the unsmoothed interface
};

/// Whether edges and corners of interfaces are found and kept.
enum class SharpEdges
{
  Off,
  On,
  Automatic ///< of the pairs of materials where the fractions tell them nearly everywhere that one surface does not do
};

/// How tetrahedra are made.
enum class TetMethod
{
  TetGen, ///< the smoothed interfaces of Cells as constrained surfaces, filled by TetGen
  Cells,  ///< a body-centred lattice of the cells; the interfaces are those of the hex mesh
  Lattice ///< a body-centred lattice of cell centres and nodes, cut where labels differ
};

/// What numbers an option takes, both ends included.
struct NumberRange
{
  double Least, Most;
};

constexpr NumberRange RelativeSizes{ 0.1, 1e6 }, Growths{ 0.0, 1e6 },
  RadiusEdgeRatios{ 1.0, 100.0 }, MinimumDihedralAngles{ 0.0, 60.0 }, OptimizationLevels{ 0, 10 };

/// What TetGen is asked for.
struct TetGenOptions
{
  double RelativeSize = 1.0;          ///< edge length at the interfaces, in cells
  double Growth = 0.3;                ///< by how much it grows over each cell of distance from them
  double RadiusEdgeRatio = 1.4;       ///< largest circumradius over shortest edge
  double MinimumDihedralAngle = 10.0; ///< degrees: what refinement strives for
  int OptimizationLevel = 4;          ///< of TetGen's flips and smoothing
};

/// What a user sets of a refined grid.
struct LevelSettings
{
  /// All interfaces get cells of the grid. false: only where Families are, so interfaces of hexahedra cross levels.
  bool FineInterfaces = true;
  /// >= 2: cells of the grid kept around those at an interface, where these get them.
  int FineLayers = 2;
};

/// Where cells may be coarser than those of the grid given to the pipelines (RefinedGrid.h).
struct LevelPlan : LevelSettings
{
  int Refinements = 0; ///< base cells are 2^Refinements cells of the grid along each axis
  std::vector<std::vector<Index>>
    Families; ///< to refine besides: of each refinement, those of this rank (OctreeKeys::FamilyKey)
};

/// What a user sets of the pipelines.
struct MeshSettings : TetGenOptions
{
  double IsoValue = 0.5;  ///< (0,1): a cell is void when its materials fill less than this
  bool MeshVoid = false;  ///< mesh the void too, as material 0
  bool StairStep = false; ///< cells become hexes, nothing is inserted or moved
  Smoothing Method = Smoothing::QuadricSurface;
  double TargetScaledJacobian =
    0.0; ///< [0,1): quality against distance; 0: .55 one material, .5 several
  SharpEdges Edges = SharpEdges::Off;  ///< only with IsoValue 0.5 and Smoothing::QuadricSurface
  bool ConserveVolume = true;          ///< meet the fractions' volumes; only with IsoValue 0.5
  bool ComputeQuality = true;          ///< fill Mesh::ScaledJacobian
  TetMethod Tets = TetMethod::Lattice; ///< of tetrahedral meshes
};

struct MeshOptions : MeshSettings
{
  LevelPlan Levels;
};

/// Whether interfaces may run through cells of several levels.
inline bool InterfacesCrossLevels(const LevelPlan& levels)
{
  return levels.Refinements > 0 && !levels.FineInterfaces;
}
inline bool InterfacesCrossLevels(const MeshOptions& options)
{
  return InterfacesCrossLevels(options.Levels);
}

/// Layers of cells around the owned ones.
struct GridLayers
{
  int Ghosts = GhostLayers; ///< that are held
  int Hexes = HexLayers;    ///< of these, that are meshed too
};

/// The layers that a grid needs to be meshed. Where interfaces cross levels these are layers of the base, since what moves with a
/// node of the base is at hexes as far as a base cell away.
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
