/**
 * Domain: the uniform grid, divided into one box of cells per rank, and the exchange of values and
 * points between ranks.
 *
 * A local array holds the cells of the box and one layer of ghost cells around it, x fastest.
 * Ghosts outside of the grid are used like any others, because boundaries are open.
 */
#pragma once

#include "MaterialPoints.h"

#include <mpi.h>

#include <cmath>
#include <cstdint>
#include <vector>

namespace impact
{

using Index3 = std::array<std::int64_t, 3>;

class Domain
{
public:
  /// Divides a grid of the given numbers of cells per axis into one box per rank.
  /// @throws std::invalid_argument  if a box would be thinner than 2 cells, on all ranks
  /// @pre Collective
  Domain(MPI_Comm communicator, const Index3& cells, double spacing);
  ~Domain();
  Domain(const Domain&) = delete;
  Domain& operator=(const Domain&) = delete;

  MPI_Comm GetCommunicator() const { return this->Communicator; }
  int GetRank() const { return this->Rank; }
  double GetSpacing() const { return this->Spacing; }
  const Index3& GetCells() const { return this->Cells; }
  const Index3& GetLower() const { return this->Lower; }
  const Index3& GetUpper() const { return this->Upper; }
  /// Returns the ranks across the sides -x +x -y +y -z +z, -1 where the grid ends.
  std::array<int, 6> GetNeighbours() const;

  std::int64_t LocalSize() const { return this->Strides[2] * (this->Size(2) + 2); }
  const Index3& GetStrides() const { return this->Strides; }
  /// Returns the index of an owned or ghost cell in local arrays.
  std::int64_t Local(const Index3& cell) const
  {
    return (cell[0] - this->Lower[0] + 1) + (cell[1] - this->Lower[1] + 1) * this->Strides[1] +
      (cell[2] - this->Lower[2] + 1) * this->Strides[2];
  }
  Index3 CellOf(const Vector& position) const
  {
    Index3 cell;
    for (int a = 0; a < 3; ++a)
    {
      cell[a] = static_cast<std::int64_t>(std::floor(position[a] / this->Spacing));
    }
    return cell;
  }
  /// Calls visit(cell, local index) for each cell of the box, in the order of the arrays of Fields.
  template <class Visit>
  void ForEachCell(Visit&& visit) const;

  /// Adds up the values that several ranks store for the same cell, owned or ghost, and stores the
  /// sum on each of them. With integers, the result does not depend on the number of ranks.
  /// @param[in,out] values  local array with `channels` numbers per cell
  /// @pre Collective
  template <class T>
  void SumShared(std::vector<T>& values, int channels) const;
  /// Sets ghost cells to the values of the ranks that own them, 0 outside of the grid.
  /// @pre Collective
  template <class T>
  void FillGhosts(std::vector<T>& values, int channels) const;

  /// Sends points that left the box to the rank that owns their new cell. No point may have moved
  /// by more than one cell.
  /// @return the points outside of the grid, which are removed from `points`
  /// @pre Collective
  std::vector<MaterialPoint> Migrate(std::vector<MaterialPoint>& points) const;

  /// Returns the sum over all ranks.
  /// @pre Collective
  std::int64_t Sum(std::int64_t value) const;

private:
  std::int64_t Size(int axis) const { return this->Upper[axis] - this->Lower[axis]; }
  template <class Visit>
  void ForEachInLayers(int axis, std::int64_t first, Visit&& visit) const;
  template <class T>
  void SumAlong(int axis, std::vector<T>& values, int channels) const;
  void MigrateAlong(int axis, std::vector<MaterialPoint>& points) const;

  MPI_Comm Communicator = MPI_COMM_NULL;
  int Rank = 0;
  Index3 Cells, Lower, Upper, Strides;
  double Spacing;
  std::array<int, 6> Peers; // ranks as in GetNeighbours, but MPI_PROC_NULL where the grid ends
};

template <class Visit>
void Domain::ForEachCell(Visit&& visit) const
{
  for (std::int64_t k = this->Lower[2]; k < this->Upper[2]; ++k)
  {
    for (std::int64_t j = this->Lower[1]; j < this->Upper[1]; ++j)
    {
      for (std::int64_t i = this->Lower[0]; i < this->Upper[0]; ++i)
      {
        const Index3 cell{ i, j, k };
        visit(cell, this->Local(cell));
      }
    }
  }
}

} // namespace impact
