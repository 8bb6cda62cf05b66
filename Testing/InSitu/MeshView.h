/**
 * MeshView: a mesh with the state "velocity", of a filter or of the C interface, as plain pointers,
 * and a number that tells meshes apart.
 */
#pragma once

#include <cstdint>

class vtkUnstructuredGrid;

namespace vfm
{
namespace testing
{

struct MeshView
{
  std::int64_t Elements = 0;
  int Corners = 0;
  const double* Points = nullptr;
  const std::int64_t *Connectivity = nullptr, *PointIds = nullptr, *ElementIds = nullptr;
  const int *Materials = nullptr, *Fragments = nullptr;
  const double* Velocity = nullptr;
};

MeshView ViewOf(vtkUnstructuredGrid* mesh);
MeshView ViewOf(int sculptor);

/// A sum over the elements, so that it depends on neither their order nor their ranks: of their
/// ids, materials, fragments and velocities, and of the ids and coordinates of their points.
std::uint64_t Digest(const MeshView& mesh);

/// In MPI_COMM_WORLD. Collective.
std::uint64_t SumOverRanks(std::uint64_t mine);

} // namespace testing
} // namespace vfm
