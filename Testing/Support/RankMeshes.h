/**
 * Meshes made on one rank and on several, for comparison, and random refinements of them.
 */
#pragma once

#include "MeshCases.h"
#include "RankFields.h"

#include <functional>
#include <map>

namespace vfm
{
namespace testing
{

/// Content of a mesh by global id. Tets leave the last corners at 0.
struct MergedMesh
{
  std::map<Index, std::array<double, 5>> Points;    // coordinates, dimension, geometry
  std::map<Index, std::array<double, 11>> Elements; // ids of points, material, fragment, quality
  std::map<std::array<Index, 4>, std::array<int, 4>> Facets; // surface, materials, side
  std::map<std::array<Index, 2>, int> CurveEdges;            // curves
  std::map<Index, int> Vertices;
  GeometryTables Tables; // rows of all ranks, with their numbers
  int Corners = 0;
  int Conflicts = 0;

  void Add(const Mesh& m);
  /// Returns one mesh, without facets.
  Mesh Join() const;
};

/// Joins the rows of a rank to those of others. Tables have the numbers of their rows then.
/// @return number of rows of both with different values
int JoinTables(const GeometryTables& more, GeometryTables& tables);

struct RankMesh
{
  MergedMesh Merged;
  std::vector<MeshReport> Reports; // by rank
};

RankMesh MakeAlone(const CartesianGrid& whole, const FractionField& field,
  const MeshOptions& options, MeshMaker make);
/// A collective change of a finished mesh.
using RankMeshChange = std::function<void(Runtime&, Mesh&, MeshReport&)>;
/// Makes a mesh on one rank per box.
/// @param change called for the mesh of each rank
RankMesh MakeOnRanks(const CartesianGrid& whole, const FractionField& field,
  const std::vector<IndexBox>& boxes, const MeshOptions& options, MeshMaker make,
  const RankMeshChange& change = {});

/// Returns an empty string, or the number of facets, their points, edges of curves, vertices and
/// tables that are not bitwise identical to the result of one rank. They do not depend on the
/// number of ranks even with TetGen, whose elements do.
std::string FindGeometryDifference(const MergedMesh& made, const MergedMesh& alone);

/// Returns FindGeometryDifference and the number of different points, elements and reports.
std::string FindDifference(const RankMesh& made, const RankMesh& alone);

/// Expects the mesh and report of one rank for each division into boxes.
void CompareWithSerial(const CartesianGrid& whole, const FractionField& field,
  const std::vector<std::vector<IndexBox>>& cuts, const MeshOptions& options,
  MeshMaker make = MakeHexMesh);

/// Counts the entries of one map that are missing or different in the other.
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

/// Returns the coordinates by id of points of facets between materials. Points on sides of the
/// domain may differ between meshes.
std::map<Index, std::array<double, 3>> InterfacePoints(const Mesh& mesh);

/// Returns labels in blocks of 2^refinements cells. One block in 40 has a random label of void and
/// two materials, the others have material 1.
FractionField MakeBlockLabels(const CartesianGrid& grid, int refinements, unsigned seed);

/// Returns three materials with almost equal fractions in every cell. Material 1 is slightly larger
/// or, in a share of the cells, a random material. Such noise can change labels at almost no cost,
/// so coarser cells and transitions stay where they were requested.
FractionField MakeNearTies(const CartesianGrid& grid, double share, unsigned seed);

/// Returns random families of every level (LevelPlan::Families).
std::vector<std::vector<Index>> MakeRandomFamilies(
  const CartesianGrid& grid, int refinements, double chance, unsigned seed);

/// Returns families of every level in the lower part of the domain along x; the box of each level
/// is shorter than the one before.
std::vector<std::vector<Index>> RefineBelow(
  const CartesianGrid& grid, int refinements, double share);

/// Cuts a box between base cells as CutBox does.
std::vector<IndexBox> CutBaseBox(
  const CartesianGrid& grid, int refinements, int ranks, int axis = -1);

} // namespace testing
} // namespace vfm
