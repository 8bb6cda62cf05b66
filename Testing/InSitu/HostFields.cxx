#include "HostFields.h"

#include "CMLPSculptor.c.h"
#include "HostImages.h"

#include "vtkMultiBlockDataSet.h"
#include "vtkVolumeFractionMeshAlgorithm.h"

namespace vfm
{
namespace testing
{
namespace
{

/// Returns the fraction of the ball in a cell, from samples.
double FractionOfBall(const Index3& cell)
{
  constexpr int samples = 4;
  int inside = 0;
  for (int s = 0; s < samples * samples * samples; ++s)
  {
    const int at[3] = { s % samples, s / samples % samples, s / (samples * samples) };
    double distance = 0.0;
    for (int a = 0; a < 3; ++a)
    {
      const double centre = a == 2 ? 8.0 : 0.5 * static_cast<double>(HostCells[a]);
      const double x = static_cast<double>(cell[a]) + (at[a] + 0.5) / samples - centre;
      distance += x * x;
    }
    inside += distance < 16.0;
  }
  return inside / static_cast<double>(samples * samples * samples);
}

} // namespace

HostFields::HostFields(int rank, int ranks)
{
  int layout[3] = { 0, 0, 0 };
  MPI_Dims_create(ranks, 3, layout);
  int stride = 1;
  for (int a = 0; a < 3; ++a)
  {
    const int place = rank / stride % layout[a];
    this->Cells.Lower[a] = HostCells[a] * place / layout[a];
    this->Cells.Upper[a] = HostCells[a] * (place + 1) / layout[a];
    this->Intervals[a] = static_cast<int>(this->Cells.Size(a));
    this->Bounds[a] = HostOrigin[a] + HostSpacing[a] * static_cast<double>(this->Cells.Lower[a]);
    this->Bounds[3 + a] =
      HostOrigin[a] + HostSpacing[a] * static_cast<double>(this->Cells.Upper[a]);
    this->Neighbours[2 * a] = place > 0 ? rank - stride : -1;
    this->Neighbours[2 * a + 1] = place + 1 < layout[a] ? rank + stride : -1;
    stride *= layout[a];
  }
  for (Index k = this->Cells.Lower[2]; k < this->Cells.Upper[2]; ++k)
  {
    for (Index j = this->Cells.Lower[1]; j < this->Cells.Upper[1]; ++j)
    {
      for (Index i = this->Cells.Lower[0]; i < this->Cells.Upper[0]; ++i)
      {
        const double ball = FractionOfBall({ { i, j, k } });
        const double plate = k < 5 ? 1.0 - ball : 0.0;
        this->Ball.push_back(ball);
        this->Plate.push_back(plate);
        this->Labels.push_back(ball + plate < 0.5 ? 0 : ball >= plate ? 1 : 2);
        this->Density.push_back(2.0 + 0.1 * static_cast<double>(i + 2 * j));
        for (Index x : { i, j, k })
        {
          this->Velocity.push_back(static_cast<double>(x));
        }
      }
    }
  }
}

int MeshFromData(int sculptor, const HostFields& fields, double* fractions, int refine,
  int stairStep, int smooth, int tets)
{
  const auto& box = fields.Bounds;
  const auto& intervals = fields.Intervals;
  const auto& ranks = fields.Neighbours;
  return c_mesh_from_data(sculptor, box[0], box[1], box[2], box[3], box[4], box[5], intervals[0],
    intervals[1], intervals[2], fractions, ranks[1], ranks[0], ranks[3], ranks[2], ranks[5],
    ranks[4], refine, stairStep, smooth, tets);
}

int CreateSculptor(const HostFields& fields)
{
  int sculptor = 0;
  const bool isGood = sculptor_create(&sculptor) == SCULPTOR_OK &&
    sculptor_set_option(sculptor, "Method", "Lattice") == SCULPTOR_OK &&
    sculptor_set_box(sculptor, fields.Bounds.data(), fields.Intervals.data()) == SCULPTOR_OK &&
    sculptor_set_neighbours(sculptor, fields.Neighbours.data()) == SCULPTOR_OK &&
    sculptor_add_material(sculptor, "ball", fields.Ball.data()) == SCULPTOR_OK &&
    sculptor_add_material(sculptor, "plate", fields.Plate.data()) == SCULPTOR_OK;
  return isGood ? sculptor : 0;
}

void MeshWhole(const HostFields& fields, vtkVolumeFractionMeshAlgorithm& mesher)
{
  const auto& bounds = fields.Bounds;
  HostGrid grid{ { { bounds[0], bounds[1], bounds[2] } }, {}, HostCells, {} };
  for (int a = 0; a < 3; ++a) // computed as from the host's bounding boxes
  {
    grid.Spacing[a] = (bounds[3 + a] - bounds[a]) / static_cast<double>(HostCells[a]);
  }
  grid.Boxes = { { fields.Cells,
    { MakeHostArray("ball", fields.Ball.data()), MakeHostArray("plate", fields.Plate.data()),
      MakeHostArray("velocity", fields.Velocity.data(), 3),
      MakeHostArray("density", fields.Density.data()) } } };
  mesher.SetController(nullptr);
  mesher.AddVolumeFractionArray("ball");
  mesher.AddVolumeFractionArray("plate");
  mesher.AddStateArray("velocity");
  mesher.SetInputDataObject(MakeBlocks(grid, 0, 1)->GetBlock(0));
  mesher.Update();
}

int MyRank()
{
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  return rank;
}

int NumberOfRanks()
{
  int ranks = 1;
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  return ranks;
}

} // namespace testing
} // namespace vfm
