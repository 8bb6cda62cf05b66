/// The C interface on several ranks gives bitwise identical results to the filter;
/// each rank receives its own cells.
#include "HostFields.h"
#include "MeshView.h"
#include "Sculptor.h"

#include "vtkUnstructuredGrid.h"
#include "vtkVolumeFractionToHex.h"
#include "vtkVolumeFractionToTet.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

namespace
{

/// Largest ratio of the widths of a cell; the ratio of the host is smaller unless stretched.
constexpr double LargestRatio = 1.5;

/// Returns the fields of a rank, with cells stretched along z.
HostFields MakeFields(int rank, int ranks, double stretch)
{
  HostFields fields(rank, ranks);
  fields.Bounds[2] *= stretch;
  fields.Bounds[5] *= stretch;
  return fields;
}

/// Returns the digest of the filter's mesh of the whole field on one rank.
std::uint64_t DigestOfFilter(vtkVolumeFractionMeshAlgorithm* mesher, double stretch)
{
  MeshWhole(MakeFields(0, 1, stretch), *mesher);
  EXPECT_GT(mesher->GetOutput()->GetNumberOfCells(), 0);
  return Digest(ViewOf(mesher->GetOutput()));
}

/// Makes the mesh by the C interface; the caller deletes the returned sculptor.
int MakeMesh(const HostFields& f, bool tets, bool knowsNeighbours)
{
  int sculptor = 0;
  EXPECT_EQ(sculptor_create(&sculptor), SCULPTOR_OK);
  if (tets)
  {
    sculptor_set_option(sculptor, "Method", "Cells");
  }
  EXPECT_EQ(sculptor_set_option(sculptor, "MaximumAspectRatio", "1.5"), SCULPTOR_OK);
  EXPECT_EQ(sculptor_set_communicator(sculptor, MPI_Comm_c2f(MPI_COMM_WORLD)), SCULPTOR_OK);
  sculptor_set_box(sculptor, f.Bounds.data(), f.Intervals.data());
  sculptor_set_neighbours(sculptor, knowsNeighbours ? f.Neighbours.data() : nullptr);
  sculptor_add_material(sculptor, "ball", f.Ball.data());
  sculptor_add_material(sculptor, "plate", f.Plate.data());
  sculptor_add_state(sculptor, "velocity", 3, f.Velocity.data());
  EXPECT_EQ(sculptor_make_mesh(sculptor, tets), SCULPTOR_OK) << sculptor_error_text(sculptor);
  return sculptor;
}

void ExpectFiltersMesh(bool tets, bool knowsNeighbours, double stretch = 1.0)
{
  const HostFields f = MakeFields(MyRank(), NumberOfRanks(), stretch);
  const int sculptor = MakeMesh(f, tets, knowsNeighbours);
  vtkNew<vtkVolumeFractionToHex> hexes;
  vtkNew<vtkVolumeFractionToTet> lattice;
  lattice->SetMethod(vtkVolumeFractionToTet::METHOD_CELLS);
  hexes->SetMaximumAspectRatio(LargestRatio);
  lattice->SetMaximumAspectRatio(LargestRatio);
  EXPECT_EQ(SumOverRanks(Digest(ViewOf(sculptor))),
    tets ? DigestOfFilter(lattice, stretch) : DigestOfFilter(hexes, stretch));
  EXPECT_EQ(sculptor_delete(sculptor), SCULPTOR_OK);
}

} // namespace

TEST(SculptorRanks, HexesAreThoseOfTheFilter)
{
  ExpectFiltersMesh(false, true);
}

TEST(SculptorRanks, TetsAreThoseOfTheFilter)
{
  ExpectFiltersMesh(true, true);
}

TEST(SculptorRanks, AlsoWithoutNeighbours)
{
  ExpectFiltersMesh(false, false);
}

TEST(SculptorRanks, LongCellsAreCut)
{
  ExpectFiltersMesh(false, true, 2.0);
  ExpectFiltersMesh(true, false, 4.0);
}

TEST(SculptorRanks, EachRankMeshesItsOwnCells)
{
  const HostFields f(MyRank(), NumberOfRanks());
  const int sculptor = MakeMesh(f, false, true);
  const MeshView mesh = ViewOf(sculptor);
  for (std::int64_t e = 0; e < mesh.Elements; ++e)
  {
    const std::int64_t key = (mesh.ElementIds[e] - 1) / 7;
    const Index3 cell{ { key % HostCells[0], key / HostCells[0] % HostCells[1],
      key / (HostCells[0] * HostCells[1]) } };
    ASSERT_TRUE(f.Cells.Contains(cell));
  }
  EXPECT_EQ(sculptor_delete(sculptor), SCULPTOR_OK);
}

TEST(SculptorRanks, CommunicatorOfHalfTheRanks)
{
  MPI_Comm half;
  MPI_Comm_split(MPI_COMM_WORLD, MyRank() % 2, MyRank(), &half);
  int rank = 0, ranks = 1, sculptor = 0;
  MPI_Comm_rank(half, &rank);
  MPI_Comm_size(half, &ranks);
  const HostFields f(rank, ranks);
  ASSERT_EQ(sculptor_create(&sculptor), SCULPTOR_OK);
  ASSERT_EQ(sculptor_set_communicator(sculptor, MPI_Comm_c2f(half)), SCULPTOR_OK);
  ASSERT_EQ(sculptor_set_box(sculptor, f.Bounds.data(), f.Intervals.data()), SCULPTOR_OK);
  ASSERT_EQ(sculptor_set_material_ids(sculptor, f.Labels.data()), SCULPTOR_OK);
  ASSERT_EQ(sculptor_make_mesh(sculptor, 0), SCULPTOR_OK) << sculptor_error_text(sculptor);
  double fragments = 0;
  ASSERT_EQ(sculptor_get_number(sculptor, "NumberOfFragments", 0, &fragments), SCULPTOR_OK);
  EXPECT_EQ(fragments, 2);
  EXPECT_EQ(sculptor_delete(sculptor), SCULPTOR_OK);
  MPI_Comm_free(&half);
}
