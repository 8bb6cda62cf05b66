/**
 * The hexahedral mesh as plain arrays, ready to be adopted by vtkUnstructuredGrid, and what was
 * measured on the way.
 */
#pragma once

#include "Buffer.h"
#include "CartesianGrid.h"

#include <string>

namespace vfm
{

/// How surface nodes are placed.
enum class Smoothing
{
  Off,            ///< valid start positions: the stair-step interface with a thin buffer layer
  QuadricSurface, ///< barrier energy, surface nodes drawn to local quadrics of the true interface
  GeometryBased   ///< barrier energy, surface nodes kept on the facets of the unsmoothed interface
};

struct HexMeshOptions
{
  double IsoValue = 0.5;  ///< (0,1): a cell is void when its materials fill less than this
  bool MeshVoid = false;  ///< mesh the void too, as material 0
  bool StairStep = false; ///< cells become hexes, nothing is inserted or moved
  Smoothing Method = Smoothing::QuadricSurface;
  double TargetScaledJacobian =
    0.0;                      ///< [0,1): quality against distance; 0: .55 one material, .5 several
  bool ConserveVolume = true; ///< meet the fractions' volumes; only with IsoValue 0.5
  bool ComputeQuality = true; ///< fill HexMesh::ScaledJacobian
};

/// The quads between two volumes, or on a side of the domain.
/// The normal of a quad points from the second material of its pair to the first.
struct SurfaceQuads
{
  Buffer<Index> Points;               ///< 4 a quad: indices of mesh points
  Buffer<int> SurfaceId;              ///< from 1, over all ranks
  Buffer<int> MaterialPair;           ///< 2 a quad, the smaller first; 0 is void or outside
  std::vector<unsigned char> IsOwned; ///< whether the quad belongs to a cell of this rank
  Buffer<int> DomainSide;             ///< -1, or 0..5 for -x +x -y +y -z +z
};

struct HexMesh
{
  Buffer<double> Points;         ///< xyz a point, length units of the grid
  Buffer<Index> PointIds;        ///< global, from 1: node key * 16 + slot + 1
  Buffer<int> GeometryDimension; ///< of each point: 3 volume, 2 surface, 1 curve, 0 vertex
  Buffer<int> GeometryId;        ///< from 1 within its dimension; in volumes the fragment
  Buffer<Index> Hexes;           ///< 8 point indices a hex, VTK order
  Buffer<Index> HexIds;          ///< global, from 1: cell key * 7 + slot + 1
  Buffer<int> Material;          ///< of each hex; 0 void
  Buffer<int> Fragment;          ///< of each hex: face-connected piece, from 1 by lowest cell
  Buffer<float> ScaledJacobian;  ///< verdict's, of each hex; empty unless asked for
  SurfaceQuads Surfaces;
  std::vector<Index>
    RowOffset; ///< first hex of each row of CartesianGrid::HexBox (x fastest), and the end
};

struct HexMeshReport
{
  std::vector<double>
    TargetVolume; ///< per material from 0: sum of its fractions (length units cubed)
  std::vector<double> MeshVolume; ///< per material from 0: of its hexes
  Index FlippedCells = 0;         ///< labels changed to make the interfaces manifold
  int ResolveRounds = 0;
  Index NumberOfFragments = 0;
  Index NumberOfSurfaces = 0, NumberOfCurves = 0, NumberOfVertices = 0;
  double MinimumScaledJacobian = 0.0; ///< over the hexes, when asked for
  double MeanScaledJacobian = 0.0;
  struct Stage
  {
    const char* Name;
    double Seconds;
  };
  std::vector<Stage> Stages; ///< in the order they ran
};

} // namespace vfm
