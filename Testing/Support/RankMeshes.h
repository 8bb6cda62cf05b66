/**
 * Meshes made on one rank and on several, to be compared; what to refine in them.
 */
#pragma once

#include "MeshCases.h"
#include "RankFields.h"

#include <map>

namespace vfm
{
namespace testing
{

/// What a mesh is made of, by global id. Tets leave the last places empty.
struct MergedMesh
{
  std::map<Index, std::array<double, 5>> Points;    // coordinates, dimension, geometry
  std::map<Index, std::array<double, 11>> Elements; // ids of points, material, fragment, quality
  std::map<std::array<Index, 4>, std::array<int, 4>> Facets; // surface, materials, side
  std::map<std::array<Index, 2>, int> CurveEdges;            // curves
  std::map<Index, int> Vertices;
  GeometryTables Tables; // alike on all ranks
  int Corners = 0;
  int Conflicts = 0;

  void Add(const Mesh& m);
  /// As one mesh, without its facets.
  Mesh Join() const;
};

struct RankMesh
{
  MergedMesh Merged;
  std::vector<MeshReport> Reports; // of the ranks
};

RankMesh MakeAlone(const CartesianGrid& whole, const FractionField& field,
  const MeshOptions& options, MeshMaker make);
/// Each rank with one of the boxes.
RankMesh MakeOnRanks(const CartesianGrid& whole, const FractionField& field,
  const std::vector<IndexBox>& boxes, const MeshOptions& options, MeshMaker make);

/// "", or how many facets, with their points, edges of curves, vertices and tables are not, bit for
/// bit, those of one process. These are the same from any number of ranks where the elements of
/// TetGen are not.
std::string FindGeometryDifference(const MergedMesh& made, const MergedMesh& alone);

/// "", or how many of these, of points, elements and reports are not.
std::string FindDifference(const RankMesh& made, const RankMesh& alone);

/// Expects the mesh and report of one process, however the grid is cut in boxes.
void CompareWithSerial(const CartesianGrid& whole, const FractionField& field,
  const std::vector<std::vector<IndexBox>>& cuts, const MeshOptions& options,
  MeshMaker make = MakeHexMesh);

/// Entries of one map that the other has not, or has with another value.
template <class Map>
std::size_t CountDifferences(const Map& a, const Map& b)
{
  const auto missing = [](const Map& from, const Map& in)
  {
    return std::count_if(from.begin(), from.end(),
      [&](const auto& entry)
      {
        const auto at = in.find(entry.first);
        return at == in.end() || at->second != entry.second;
      });
  };
  return static_cast<std::size_t>(std::max(missing(a, b), missing(b, a)));
}

/// Coordinates by id of the points of facets between materials; those on the domain's sides may
/// differ between meshes.
std::map<Index, std::array<double, 3>> InterfacePoints(const Mesh& mesh);

/// Labels in blocks of 2^refinements cells: a fortieth of them random, of void and two materials,
/// the others material 1.
FractionField MakeBlockLabels(const CartesianGrid& grid, int refinements, unsigned seed);

/// Three materials, all nearly equal in every cell: the most by a hair is material 1 or, in a share
/// of the cells, a random one. Labels are noise that costs next to nothing to change, so coarser
/// cells and transitions stay where they are wanted.
FractionField MakeNearTies(const CartesianGrid& grid, double share, unsigned seed);

/// Families of every level, with a chance (LevelPlan::Families).
std::vector<std::vector<Index>> MakeRandomFamilies(
  const CartesianGrid& grid, int refinements, double chance, unsigned seed);

/// CutBox in whole base cells.
std::vector<IndexBox> CutBaseBox(
  const CartesianGrid& grid, int refinements, int ranks, int axis = -1);

} // namespace testing
} // namespace vfm
