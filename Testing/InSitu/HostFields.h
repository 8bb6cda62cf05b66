/**
 * HostFields: data of a simulation with a regular layout of ranks: a ball on a plate, with a state,
 * on this rank's box of a grid of 18 x 12 x 15 cells.
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
  /// Creates the box of a rank in the layout of MPI_Dims_create.
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

/// Calls c_mesh_from_data with a rank's box and neighbours. fractions: of its cells, or null.
int MeshFromData(int sculptor, const HostFields& fields, double* fractions, int refine = 0,
  int stairStep = 0, int smooth = 1, int tets = 0);

/// Creates a handle of the C interface with a rank's box and neighbours, the materials ball and
/// plate, and the method Lattice. Returns 0 after an error.
int CreateSculptor(const HostFields& fields);

/// Meshes the whole grid with a filter on this rank only. fields: of a box that is the whole grid.
/// The results are at the filter's output ports.
void MeshWhole(const HostFields& fields, vtkVolumeFractionMeshAlgorithm& mesher);

/// Rank of this process and number of ranks in MPI_COMM_WORLD.
int MyRank();
int NumberOfRanks();

} // namespace testing
} // namespace vfm
