/**
 * Domain: the uniform grid, cut into one box of cells for each rank, and what ranks tell each other
 * about it.
 *
 * A local array holds the cells of the box and one layer of ghost cells around it, x fastest. The
 * outermost ghosts lie outside of the grid and are used as well: boundaries are open.
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
  /// Collective. Throws std::invalid_argument on all ranks when a box would be thinner than 2
  /// cells.
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
  /// Ranks across -x +x -y +y -z +z, or -1.
  std::array<int, 6> GetNeighbours() const;

  std::int64_t LocalSize() const { return this->Strides[2] * (this->Size(2) + 2); }
  const Index3& GetStrides() const { return this->Strides; }
  /// Index of a cell of the box, or of a ghost, in local arrays.
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
  /// Calls visit(cell, local index) for each cell of the box, in the order of Fields.
  template <class Visit>
  void ForEachCell(Visit&& visit) const;

  /// Collective: adds up what ranks hold of the same cells, ghosts included, so that all of them
  /// hold the sums. values: `channels` numbers a cell. With integers the result does not depend on
  /// the ranks.
  template <class T>
  void SumShared(std::vector<T>& values, int channels) const;
  /// Collective: sets the ghosts to what their owners hold; 0 outside of the grid.
  template <class T>
  void FillGhosts(std::vector<T>& values, int channels) const;

  /// Collective: hands points that left the box to the rank that owns their cell now; none may have
  /// moved more than a cell. Points outside of the grid are taken out and returned.
  std::vector<MaterialPoint> Migrate(std::vector<MaterialPoint>& points) const;

  /// Collective sum over the ranks.
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
  std::array<int, 6> Peers; // MPI_PROC_NULL for none
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
