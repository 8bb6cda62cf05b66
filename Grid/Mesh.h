/**
 * A hexahedral or tetrahedral mesh as plain arrays, ready to be adopted by vtkUnstructuredGrid, the options
 * that make it, and what was measured on the way.
 */
#pragma once

#include "Buffer.h"
#include "CartesianGrid.h"
#include "Ranks.h"

#include <memory>
#include <string>

namespace vfm
{

class RefinedGrid;

/// How surface nodes are placed.
enum class Smoothing
{
  Off,            ///< valid start positions: the stair-step interface with a thin buffer layer
  QuadricSurface, ///< barrier energy, surface nodes drawn to local quadrics of the true interface
  GeometryBased   ///< barrier energy, surface nodes kept on the facets of the unsmoothed interface
};

/// How tetrahedra are made.
enum class TetMethod
{
  TetGen, ///< the smoothed interfaces of Cells as constrained surfaces, filled by TetGen
  Cells,  ///< a body-centred lattice of the cells; the interfaces are those of the hex mesh
  Lattice ///< a body-centred lattice of cell centres and nodes, cut where labels differ
};

/// What TetGen is asked for.
struct TetGenOptions
{
  double RelativeSize = 1.0;    ///< > 0: edge length at the interfaces, in cells
  double Growth = 0.3;          ///< >= 0: by how much it grows over each cell of distance from them
  double RadiusEdgeRatio = 1.4; ///< >= 1: largest circumradius over shortest edge
  double MinimumDihedralAngle = 10.0; ///< 0..60 degrees: what refinement strives for
  int OptimizationLevel = 4;          ///< 0..10: of TetGen's flips and smoothing
};

/// Where cells may be coarser than those of the grid given to the pipelines (RefinedGrid.h).
struct LevelPlan
{
  int Refinements = 0; ///< base cells are 2^Refinements cells of the grid along each axis
  bool FineInterfaces =
    true; ///< all interfaces get cells of the grid; false: where Octets are alone, so interfaces cross levels
  int FineLayers =
    2; ///< >= 2: cells of the grid kept around those at an interface, where these get them
  std::vector<std::vector<Index>>
    Octets; ///< to refine besides: of each refinement, those of this rank (RefinedLattice::OctetKey)
};

struct MeshOptions
{
  double IsoValue = 0.5;  ///< (0,1): a cell is void when its materials fill less than this
  bool MeshVoid = false;  ///< mesh the void too, as material 0
  bool StairStep = false; ///< cells become hexes, nothing is inserted or moved
  Smoothing Method = Smoothing::QuadricSurface;
  double TargetScaledJacobian =
    0.0;                      ///< [0,1): quality against distance; 0: .55 one material, .5 several
  bool ConserveVolume = true; ///< meet the fractions' volumes; only with IsoValue 0.5
  bool ComputeQuality = true; ///< fill Mesh::ScaledJacobian
  TetMethod Tets = TetMethod::Lattice; ///< of tetrahedral meshes
  TetGenOptions TetGen;                ///< of TetMethod::TetGen
  LevelPlan Levels;
};

/// The faces between two volumes, or on a side of the domain: quads of hexes, triangles of tets.
/// The normal of a facet points from the second material of its pair to the first.
struct SurfaceFacets
{
  Buffer<Index> Points;               ///< Mesh::CornersOfFacet a facet: indices of mesh points
  Buffer<int> SurfaceId;              ///< from 1, over all ranks
  Buffer<int> MaterialPair;           ///< 2 a facet, the smaller first; 0 is void or outside
  std::vector<unsigned char> IsOwned; ///< whether this rank writes the facet
  Buffer<int> DomainSide;             ///< -1, or 0..5 for -x +x -y +y -z +z
};

struct Mesh
{
  int Corners = 8;       ///< of an element: 8 hexes, 4 tets
  Index PointSlots = 16; ///< point id = node key * PointSlots + slot + 1 (NodeOfPoint)
  Index ElementSlots =
    7;                   ///< element id = key * ElementSlots + slot + 1 (CellOfElement); 0: counted
  Buffer<double> Points; ///< xyz a point, length units of the grid
  Buffer<Index> PointIds;        ///< global, from 1, ascending
  Buffer<int> GeometryDimension; ///< of each point: 3 volume, 2 surface, 1 curve, 0 vertex
  Buffer<int> GeometryId;        ///< from 1 within its dimension; in volumes the fragment
  Buffer<Index> Elements;        ///< point indices, Corners an element, VTK order
  Buffer<Index> ElementIds;      ///< global, from 1, ascending
  Buffer<int> Material;          ///< of each element; 0 void
  Buffer<int> Fragment; ///< of each element: face-connected piece, numbered from 1 over all ranks
  Buffer<float> ScaledJacobian; ///< verdict's, of each element; empty unless asked for
  SurfaceFacets Surfaces;
  std::vector<Index> RowOffset; ///< of hexes of the grid's own cells: the first of each row of
                                ///< CartesianGrid::HexBox (x fastest), and the end
  std::shared_ptr<const RefinedGrid> Levels; ///< null: all hexes are those of the grid's own cells

  int CornersOfFacet() const { return this->Corners == 8 ? 4 : 3; }
};

/// The node of a key (CartesianGrid::NodeKey).
Index3 NodeOfKey(const CartesianGrid& grid, Index key);
/// The grid node that owns a point, from its id. Tets: the node of the block in which it starts.
Index3 NodeOfPoint(const CartesianGrid& grid, const Mesh& mesh, Index id);
/// The cells of the grid that an element was made of, one or those of a coarser cell, from its id. Tets: above their face, in the
/// domain. Those of TetGen have none.
IndexBox CellsOfElement(const CartesianGrid& grid, const Mesh& mesh, Index id);
/// The lowest of them.
Index3 CellOfElement(const CartesianGrid& grid, const Mesh& mesh, Index id);

/// The cell of the grid at a node, clamped on the upper sides of the domain.
Index3 CellOfBlock(const CartesianGrid& grid, const Index3& node);
/// Throws InputError when ids of so many slots a node do not fit.
void CheckIds(const CartesianGrid& grid, Index slots);
/// Throws InputError on all ranks when there are more points than 32 bits number on any. Collective.
void CheckNumberOfPoints(Index points, Ranks& ranks);

/// Drops the elements, points and facets that belong to other ranks' cells.
void KeepOwned(Mesh& mesh, const CartesianGrid& grid);

struct MeshReport
{
  std::vector<double>
    TargetVolume; ///< per material from 0: sum of its fractions (length units cubed)
  std::vector<double> MeshVolume;             ///< per material from 0: of its elements
  std::vector<double> FragmentTargetVolume;   ///< by fragment, [0] unused
  Index RemovedRegions = 0, RemovedCells = 0; ///< small ones given to what is around them
  Index FlippedCells = 0; ///< labels of cells or leaves changed to make the interfaces manifold
  int ResolveRounds = 0;
  Index NumberOfFragments = 0;
  Index NumberOfSurfaces = 0, NumberOfCurves = 0, NumberOfVertices = 0;
  double MinimumScaledJacobian = 0.0; ///< over the elements, when asked for
  double MeanScaledJacobian = 0.0;
  double MinimumDihedralAngle = 0.0,
         MaximumDihedralAngle = 0.0;      ///< degrees, of tets, when asked for
  std::array<Index, 18> DihedralAngles{}; ///< of tets: how many in each ten degrees, when asked for
  Index RefusedParts = 0;                 ///< parts that TetGen refused and that Cells meshed
  struct Level
  {
    Index Octets = 0; ///< refined to the next level
    Index Added = 0;  ///< of those, the ones that were not asked for but that transitions need
    Index Cells = 0;  ///< elements that are, or are made in, whole cells of the level
  };
  std::vector<Level> Levels; ///< from the base; empty without refinements
  Index TransitionCells = 0; ///< elements of transitions
  int LevelRounds =
    0; ///< in which cells between levels by place were refined: where labels had to be changed, or no valid mesh starts
  struct Stage
  {
    const char* Name;
    double Seconds;
  };
  std::vector<Stage> Stages; ///< in the order they ran
};

} // namespace vfm
