/**
 * Which cells of a grid ask to be halved, and how often, from the fractions: what decides the levels of a refined grid.
 *
 * Lengths are counted in cells; those of uneven grids count as cubes. The same on any number of ranks and threads.
 */
#pragma once

#include "Base/Partition.h"
#include "Base/Runtime.h"
#include "Fractions/FractionField.h"
#include "Octree/OctreeKeys.h"

namespace vfm
{

/// Cells that are to be halved so many times, whatever they hold.
struct ChosenBox
{
  IndexBox Cells;
  Index Halvings;
};

/// What asks for halvings; 0 or less: off.
struct RefinementCriteria
{
  /// Films, gaps, rods and small bodies thinner than so many cells, at most LargestThickness (ThinFeatures.h), until
  /// they are no longer.
  double ThinCells = 2.0;
  /// Interfaces that turn by more than so many radians over a cell (0.5: a radius of two cells), until they turn by less.
  double CurvaturePerCell = 0.0;
  /// Cells whose labels the label condition changes: once.
  bool FlippedCells = false;
  /// Cells within so many layers of an interface, the cells at it the first: to the maximum level.
  int InterfaceLayers = 0;
  /// Cells chosen by name, in any order; those that are not owned ask for nothing here.
  std::vector<ChosenBox> Chosen;
  /// The most halvings.
  int MaximumLevel = 1;
};

/// A cell that wants to be halved.
struct RefinementRequest
{
  Index Cell;   ///< CartesianGrid::CellKey
  int Halvings; ///< 1..MaximumLevel
};

struct RefinementRequests
{
  std::vector<RefinementRequest> Cells; ///< owned, ascending
  int Refinements = 0;                  ///< the most halvings on any rank
  // how many cells each criterion asks for, over all ranks; some by several
  Index ThinCells = 0, CurvedCells = 0, FlippedCells = 0, NearCells = 0, ChosenCells = 0;
  Index AllCells = 0;
};

/// Asks the criteria. grid: with ghost layers (GhostLayers); isoValue: of the labels, as in MeshOptions.
/// Throws InputError when a criterion is out of range. Collective.
RefinementRequests FindRefinement(const CartesianGrid& grid, const FractionField& fractions,
  const RefinementCriteria& criteria, double isoValue, const Partition& partition,
  Runtime& runtime);

/// Adds to those of each refinement (OctreeKeys::FamilyKey), in any order and some twice, the families that hold what cells of a level
/// want to be halved. layers: so many more cells around, of the level that the place wants; >= 0.
void AddRequestedFamilies(const OctreeKeys& lattice, int level, const ChosenBox& requested,
  int layers, std::vector<std::vector<Index>>& families);

/// The families of each refinement (OctreeKeys::FamilyKey) that hold what this rank's cells want to be halved, ascending: what
/// OctantFamilies asks for. lattice: of the same grid, with at least wishes.Refinements refinements. layers: as of AddRequestedFamilies.
std::vector<std::vector<Index>> FindRequestedFamilies(
  const OctreeKeys& lattice, const RefinementRequests& requests, int layers = 0);

} // namespace vfm
