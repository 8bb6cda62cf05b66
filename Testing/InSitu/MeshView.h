/**
 * MeshView: a mesh with the state "velocity" as plain pointers, from a filter or the C interface,
 * and a digest that distinguishes meshes.
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

/// Sums a hash of each element: ids, materials, fragments, velocities, and ids and coordinates of
/// points. The sum does not depend on the order or the ranks of elements.
std::uint64_t Digest(const MeshView& mesh);

/// Sums over MPI_COMM_WORLD. @pre Collective
std::uint64_t SumOverRanks(std::uint64_t mine);

} // namespace testing
} // namespace vfm
