#include "Domain.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace impact
{
namespace
{

constexpr std::int64_t ThinnestBox = 2; // two neighbours of a box must not share a cell

/// Returns the numbers of boxes per axis, `ranks` in total, with the smallest area between boxes.
/// All three are 0 if each division has a box that is too thin.
std::array<int, 3> ChooseCuts(const Index3& cells, int ranks)
{
  std::array<int, 3> best{ 0, 0, 0 };
  double least = 0.;
  for (int x = 1; x <= ranks; ++x)
  {
    for (int y = 1; ranks % x == 0 && y <= ranks / x; ++y)
    {
      const int z = ranks / x / y;
      if (x * y * z != ranks || cells[0] < ThinnestBox * x || cells[1] < ThinnestBox * y ||
        cells[2] < ThinnestBox * z)
      {
        continue;
      }
      const double cuts = double(x - 1) / cells[0] + double(y - 1) / cells[1] +
        double(z - 1) / cells[2]; // area between boxes over the grid's volume
      if (best[0] == 0 || cuts < least)
      {
        best = { x, y, z };
        least = cuts;
      }
    }
  }
  return best;
}

} // namespace

Domain::Domain(MPI_Comm communicator, const Index3& cells, double spacing) :
  Cells(cells), Spacing(spacing)
{
  int ranks = 0;
  MPI_Comm_size(communicator, &ranks);
  std::array<int, 3> cuts = ChooseCuts(cells, ranks);
  if (cuts[0] == 0)
  {
    throw std::invalid_argument("the grid is too small for " + std::to_string(ranks) +
      " ranks: each needs a box of 2 cells per axis");
  }
  const int periodic[3] = { 0, 0, 0 };
  MPI_Cart_create(communicator, 3, cuts.data(), periodic, 0, &this->Communicator);
  MPI_Comm_rank(this->Communicator, &this->Rank);
  int place[3];
  MPI_Cart_coords(this->Communicator, this->Rank, 3, place);
  for (int a = 0; a < 3; ++a)
  {
    this->Lower[a] = cells[a] * place[a] / cuts[a];
    this->Upper[a] = cells[a] * (place[a] + 1) / cuts[a];
    MPI_Cart_shift(this->Communicator, a, 1, &this->Peers[2 * a], &this->Peers[2 * a + 1]);
  }
  this->Strides = { 1, this->Size(0) + 2, (this->Size(0) + 2) * (this->Size(1) + 2) };
}

Domain::~Domain()
{
  MPI_Comm_free(&this->Communicator);
}

std::array<int, 6> Domain::GetNeighbours() const
{
  std::array<int, 6> ranks = this->Peers;
  std::replace(ranks.begin(), ranks.end(), int(MPI_PROC_NULL), -1);
  return ranks;
}

/// Calls visit(local index) for the cells of two layers, ghosts included. `first` is the index of
/// the lower layer, 0 for the lower ghosts.
template <class Visit>
void Domain::ForEachInLayers(int axis, std::int64_t first, Visit&& visit) const
{
  Index3 lower{ 0, 0, 0 }, upper{ this->Size(0) + 2, this->Size(1) + 2, this->Size(2) + 2 };
  lower[axis] = first;
  upper[axis] = first + 2;
  for (std::int64_t k = lower[2]; k < upper[2]; ++k)
  {
    for (std::int64_t j = lower[1]; j < upper[1]; ++j)
    {
      for (std::int64_t i = lower[0]; i < upper[0]; ++i)
      {
        visit(i + j * this->Strides[1] + k * this->Strides[2]);
      }
    }
  }
}

/// Adds up shared values along one axis. Two adjacent boxes share two layers: the outermost cells
/// of each box are the ghosts of the other.
template <class T>
void Domain::SumAlong(int axis, std::vector<T>& values, int channels) const
{
  const std::int64_t first[2] = { 0, this->Size(axis) };
  std::vector<T> sent[2], received[2];
  for (int side = 0; side < 2; ++side)
  {
    if (this->Peers[2 * axis + side] == MPI_PROC_NULL)
    {
      continue;
    }
    this->ForEachInLayers(axis, first[side],
      [&](std::int64_t cell)
      {
        const T* from = values.data() + cell * channels;
        sent[side].insert(sent[side].end(), from, from + channels);
      });
    received[side].resize(sent[side].size());
  }
  for (int side = 0; side < 2; ++side)
  {
    const int to = this->Peers[2 * axis + side], from = this->Peers[2 * axis + 1 - side];
    MPI_Sendrecv(sent[side].data(), static_cast<int>(sent[side].size() * sizeof(T)), MPI_BYTE, to,
      side, received[1 - side].data(), static_cast<int>(received[1 - side].size() * sizeof(T)),
      MPI_BYTE, from, side, this->Communicator, MPI_STATUS_IGNORE);
  }
  for (int side = 0; side < 2; ++side)
  {
    const T* from = received[side].data();
    if (received[side].empty())
    {
      continue;
    }
    this->ForEachInLayers(axis, first[side],
      [&](std::int64_t cell)
      {
        for (int c = 0; c < channels; ++c)
        {
          values[cell * channels + c] += *from++;
        }
      });
  }
}

template <class T>
void Domain::SumShared(std::vector<T>& values, int channels) const
{
  for (int axis = 0; axis < 3; ++axis)
  {
    this->SumAlong(axis, values, channels);
  }
}

template <class T>
void Domain::FillGhosts(std::vector<T>& values, int channels) const
{
  std::vector<T> own(values.size());
  this->ForEachCell([&](const Index3&, std::int64_t cell)
    { std::copy_n(values.data() + cell * channels, channels, own.data() + cell * channels); });
  values.swap(own);
  this->SumShared(values, channels);
}

template void Domain::SumShared(std::vector<std::int64_t>&, int) const;
template void Domain::FillGhosts(std::vector<double>&, int) const;

void Domain::MigrateAlong(int axis, std::vector<MaterialPoint>& points) const
{
  std::vector<MaterialPoint> leaving[2];
  std::size_t kept = 0;
  for (const MaterialPoint& point : points)
  {
    const std::int64_t cell = this->CellOf(point.Position)[axis];
    if (cell < this->Lower[axis] || cell >= this->Upper[axis])
    {
      leaving[cell >= this->Upper[axis]].push_back(point);
    }
    else
    {
      points[kept++] = point;
    }
  }
  points.resize(kept);
  for (int side = 0; side < 2; ++side)
  {
    const int to = this->Peers[2 * axis + side], from = this->Peers[2 * axis + 1 - side];
    std::int64_t count = static_cast<std::int64_t>(leaving[side].size()), arriving = 0;
    MPI_Sendrecv(&count, 1, MPI_INT64_T, to, side, &arriving, 1, MPI_INT64_T, from, side,
      this->Communicator, MPI_STATUS_IGNORE);
    const std::size_t old = points.size();
    points.resize(old + arriving);
    MPI_Sendrecv(leaving[side].data(), static_cast<int>(count * sizeof(MaterialPoint)), MPI_BYTE,
      to, side, points.data() + old, static_cast<int>(arriving * sizeof(MaterialPoint)), MPI_BYTE,
      from, side, this->Communicator, MPI_STATUS_IGNORE);
  }
}

std::vector<MaterialPoint> Domain::Migrate(std::vector<MaterialPoint>& points) const
{
  const auto isInside = [&](const MaterialPoint& point)
  {
    const Index3 cell = this->CellOf(point.Position);
    bool inside = true;
    for (int a = 0; a < 3; ++a)
    {
      inside = inside && cell[a] >= 0 && cell[a] < this->Cells[a];
    }
    return inside;
  };
  const auto outside = std::stable_partition(points.begin(), points.end(), isInside);
  const std::vector<MaterialPoint> lost(outside, points.end());
  points.erase(outside, points.end());
  for (int axis = 0; axis < 3; ++axis)
  {
    this->MigrateAlong(axis, points);
  }
  return lost;
}

std::int64_t Domain::Sum(std::int64_t value) const
{
  std::int64_t sum = 0;
  MPI_Allreduce(&value, &sum, 1, MPI_INT64_T, MPI_SUM, this->Communicator);
  return sum;
}

} // namespace impact
