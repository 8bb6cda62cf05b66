/// The C interface on several ranks against the filter alone: the same bits, each rank its own cells.
#include "HostFields.h"
#include "HostGrid.h"
#include "Sculptor.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolumeFractionToHex.h"
#include "vtkVolumeFractionToTet.h"

#include <gtest/gtest.h>

#include <cstring>

using namespace vfm;
using namespace vfm::testing;

namespace
{

constexpr double LargestRatio =
  1.5; // of the widths of a cell: those of the host are nearer, unless stretched

/// A mesh as plain pointers.
struct MeshView
{
  std::int64_t Elements = 0;
  int Corners = 0;
  const double* Points = nullptr;
  const std::int64_t *Connectivity = nullptr, *PointIds = nullptr, *ElementIds = nullptr;
  const int *Materials = nullptr, *Fragments = nullptr;
  const double* Velocity = nullptr;
};

std::uint64_t Mix(std::uint64_t hash, std::uint64_t bits)
{
  hash = (hash ^ bits) * 0x9e3779b97f4a7c15ULL;
  return hash ^ hash >> 29;
}

std::uint64_t BitsOf(double value)
{
  std::uint64_t bits;
  std::memcpy(&bits, &value, sizeof(bits));
  return bits;
}

/// A sum over the elements, so that it depends on neither their order nor their ranks.
std::uint64_t Digest(const MeshView& mesh)
{
  std::uint64_t sum = 0;
  for (std::int64_t e = 0; e < mesh.Elements; ++e)
  {
    std::uint64_t hash = Mix(mesh.ElementIds[e], mesh.Materials[e]);
    hash = Mix(hash, mesh.Fragments[e]);
    for (int c = 0; c < mesh.Corners; ++c)
    {
      const std::int64_t p = mesh.Connectivity[mesh.Corners * e + c];
      hash = Mix(hash, mesh.PointIds[p]);
      for (int a = 0; a < 3; ++a)
      {
        hash = Mix(hash, BitsOf(mesh.Points[3 * p + a]));
      }
    }
    for (int a = 0; a < 3; ++a)
    {
      hash = Mix(hash, BitsOf(mesh.Velocity[3 * e + a]));
    }
    sum += hash;
  }
  return sum;
}

template <class T>
const T* Values(vtkDataArray* array)
{
  return static_cast<const T*>(array->GetVoidPointer(0));
}

MeshView ViewOf(vtkUnstructuredGrid* mesh)
{
  MeshView view;
  view.Elements = mesh->GetNumberOfCells();
  view.Corners = mesh->GetCells()->GetMaxCellSize();
  view.Points = Values<double>(mesh->GetPoints()->GetData());
  view.Connectivity = Values<std::int64_t>(mesh->GetCells()->GetConnectivityArray());
  view.PointIds = Values<std::int64_t>(mesh->GetPointData()->GetGlobalIds());
  view.ElementIds = Values<std::int64_t>(mesh->GetCellData()->GetGlobalIds());
  view.Materials = Values<int>(mesh->GetCellData()->GetArray("MaterialId"));
  view.Fragments = Values<int>(mesh->GetCellData()->GetArray("FragmentId"));
  view.Velocity = Values<double>(mesh->GetCellData()->GetArray("velocity"));
  return view;
}

MeshView ViewOf(int sculptor)
{
  MeshView view;
  std::int64_t points = 0;
  int components = 0;
  EXPECT_EQ(sculptor_get_counts(sculptor, &points, &view.Elements, &view.Corners), SCULPTOR_OK);
  EXPECT_EQ(sculptor_get_points(sculptor, &view.Points), SCULPTOR_OK);
  EXPECT_EQ(sculptor_get_elements(sculptor, &view.Connectivity), SCULPTOR_OK);
  EXPECT_EQ(sculptor_get_point_ids(sculptor, &view.PointIds), SCULPTOR_OK);
  EXPECT_EQ(sculptor_get_element_ids(sculptor, &view.ElementIds), SCULPTOR_OK);
  EXPECT_EQ(sculptor_get_materials(sculptor, &view.Materials), SCULPTOR_OK);
  EXPECT_EQ(sculptor_get_fragments(sculptor, &view.Fragments), SCULPTOR_OK);
  EXPECT_EQ(sculptor_get_state(sculptor, "velocity", &components, &view.Velocity), SCULPTOR_OK);
  EXPECT_EQ(components, 3);
  return view;
}

/// Of a rank, with cells so many times as long along z.
HostFields MakeFields(int rank, int ranks, double stretch)
{
  HostFields fields(rank, ranks);
  fields.Bounds[2] *= stretch;
  fields.Bounds[5] *= stretch;
  return fields;
}

/// What the filter alone makes of the whole field in one process.
std::uint64_t DigestOfFilter(vtkVolumeFractionMeshAlgorithm* mesher, double stretch)
{
  const HostFields all = MakeFields(0, 1, stretch);
  HostGrid grid{ { { all.Bounds[0], all.Bounds[1], all.Bounds[2] } }, {}, HostCells, {} };
  for (int a = 0; a < 3; ++a) // as the host's bounding boxes tell it
  {
    grid.Spacing[a] = (all.Bounds[3 + a] - all.Bounds[a]) / static_cast<double>(HostCells[a]);
  }
  const HostBox box{ all.Cells,
    { MakeHostArray("ball", all.Ball.data()), MakeHostArray("plate", all.Plate.data()),
      MakeHostArray("velocity", all.Velocity.data(), 3) } };
  mesher->SetController(nullptr);
  mesher->AddVolumeFractionArray("ball");
  mesher->AddVolumeFractionArray("plate");
  mesher->AddStateArray("velocity");
  mesher->SetInputDataObject(MakeImage(grid, box));
  mesher->Update();
  EXPECT_GT(mesher->GetOutput()->GetNumberOfCells(), 0);
  return Digest(ViewOf(mesher->GetOutput()));
}

std::uint64_t SumOverRanks(std::uint64_t mine)
{
  std::uint64_t sum = 0;
  MPI_Allreduce(&mine, &sum, 1, MPI_UINT64_T, MPI_SUM, MPI_COMM_WORLD);
  return sum;
}

/// The mesh by the C interface; a sculptor to be deleted.
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
