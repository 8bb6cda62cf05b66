/**
 * HostFields: what a host code with a regular layout of ranks would hand over: a ball on a plate,
 * with a state, on this rank's box of a grid of 18 x 12 x 15 cells.
 */
#pragma once

#include "Base/CartesianGrid.h"

#include <mpi.h>

class vtkVolumeFractionMeshAlgorithm;

namespace vfm
{
namespace testing
{

struct HostFields
{
  /// The box of a rank of the layout that MPI_Dims_create chooses.
  HostFields(int rank, int ranks);

  IndexBox Cells;
  std::array<double, 6> Bounds;
  std::array<int, 3> Intervals;
  std::array<int, 6> Neighbours;
  std::vector<double> Ball, Plate, Velocity, Density; ///< 1, 1, 3, 1 components
  std::vector<int> Labels;                            ///< 0 void, 1 ball, 2 plate
};

constexpr Index3 HostCells{ { 18, 12, 15 } };
constexpr Vector3 HostOrigin{ { -1.0, 0.5, 2.0 } }, HostSpacing{ { 0.1, 0.125, 0.11 } };

/// c_mesh_from_data with a rank's box and neighbours. fractions: of its cells, or null.
int MeshFromData(int sculptor, const HostFields& fields, double* fractions, int refine = 0,
  int stairStep = 0, int smooth = 1, int tets = 0);

/// What a filter makes of the fields of a box that is the whole grid, in this process alone, is
/// then at its ports.
void MeshWhole(const HostFields& fields, vtkVolumeFractionMeshAlgorithm& mesher);

/// Of this rank and their number, in MPI_COMM_WORLD.
int MyRank();
int NumberOfRanks();

} // namespace testing
} // namespace vfm
