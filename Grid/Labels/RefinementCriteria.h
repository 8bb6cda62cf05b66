/**
 * RefinementCriteria: criteria on the fractions that mark cells for refinement. They determine the
 * levels of a refined grid.
 *
 * Lengths are in cells; cells of uneven grids count as cubes. Results are bitwise reproducible on
 * any number of ranks and threads.
 */
#pragma once

#include "Base/Partition.h"
#include "Base/Runtime.h"
#include "Fractions/FractionField.h"
#include "Octree/OctreeKeys.h"

namespace vfm
{

/// Box of cells that are halved a number of times, whatever they contain.
struct ChosenBox
{
  IndexBox Cells;
  Index Halvings;
};

/// Criteria for refinement. A value of 0 or less turns a criterion off.
struct RefinementCriteria
{
  /// Films, gaps, rods and small bodies thinner than this number of cells (ThinFeatures.h) are
  /// refined until they are not. The limit is LargestThickness.
  double ThinCells = 2.0;
  /// Interfaces that turn by more than this angle per cell, in radians, are refined until they do
  /// not. 0.5 is a radius of two cells.
  double CurvaturePerCell = 0.0;
  /// Cells whose labels the label condition changes are halved once.
  bool FlippedCells = false;
  /// Cells within this number of layers of an interface are refined to the maximum level. Cells at
  /// the interface are the first layer.
  int InterfaceLayers = 0;
  /// User-selected cells, in any order; cells that are not owned are ignored.
  std::vector<ChosenBox> Chosen;
  /// Largest number of halvings.
  int MaximumLevel = 1;
};

/// Cell marked for refinement.
struct RefinementRequest
{
  Index Cell;   ///< CartesianGrid::CellKey
  int Halvings; ///< 1 to MaximumLevel
};

/// Cells of a rank that are marked for refinement.
struct RefinementRequests
{
  std::vector<RefinementRequest> Cells; ///< owned, ascending
  int Refinements = 0;                  ///< largest number of halvings on any rank
  // Number of cells that each criterion marks, over all ranks; a cell may count for several.
  Index ThinCells = 0, CurvedCells = 0, FlippedCells = 0, NearCells = 0, ChosenCells = 0;
  Index AllCells = 0; ///< number of marked cells, over all ranks
};

/// Returns the number of halvings, 0 to most, that multiply the cells across a length by about a
/// factor.
int HalvingsFor(double factor, int most);

/// Evaluates the criteria in the owned cells.
/// @param grid  has GhostLayers ghost layers
/// @param isoValue  iso value of the labels, as in MeshOptions
/// @throws InputError  if a criterion is out of range
/// @pre Collective.
RefinementRequests FindRefinement(const CartesianGrid& grid, const FractionField& fractions,
  const RefinementCriteria& criteria, double isoValue, const Partition& partition,
  Runtime& runtime);

/// Adds the families (OctreeKeys::FamilyKey) that contain the halvings requested for
/// a box of cells.
/// @param level  level of the cells of the box
/// @param requested  cells and number of halvings
/// @param layers  number of further layers of cells around them, of the requested level, >= 0
/// @param[in,out] families  one list per refinement, unsorted, may contain duplicates
void AddRequestedFamilies(const OctreeKeys& lattice, int level, const ChosenBox& requested,
  int layers, std::vector<std::vector<Index>>& families);

/// Returns the families (OctreeKeys::FamilyKey) that contain the halvings requested for the cells
/// of this rank, as OctantFamilies expects them.
/// @param lattice  octree of the same grid, with at least requests.Refinements refinements
/// @param layers  see AddRequestedFamilies
/// @return one ascending list per refinement
std::vector<std::vector<Index>> FindRequestedFamilies(
  const OctreeKeys& lattice, const RefinementRequests& requests, int layers = 0);

} // namespace vfm
