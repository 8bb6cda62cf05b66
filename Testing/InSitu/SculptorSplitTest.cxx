/// Split interfaces and layers from the C interface on several ranks equal the filter's on one
/// rank.
#include "HostFields.h"
#include "Sculptor.h"

#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolumeFractionToHex.h"
#include "vtkVolumeFractionToTet.h"

#include <gtest/gtest.h>

#include <map>

using namespace vfm;
using namespace vfm::testing;

namespace
{

using Numbers = std::vector<std::int64_t>;
/// Materials of both sides and global ids of the nodes of each cohesive element, by its id.
using Elements = std::map<std::int64_t, Numbers>;

std::int64_t IdOf(vtkDataArray* ids, vtkIdType at)
{
  return static_cast<std::int64_t>(ids->GetComponent(at, 0));
}

Elements ElementsOf(vtkUnstructuredGrid* grid)
{
  Elements all;
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    Numbers& numbers = all[IdOf(grid->GetCellData()->GetGlobalIds(), c)];
    vtkDataArray* pairs = grid->GetCellData()->GetArray("MaterialPair");
    numbers = { static_cast<std::int64_t>(pairs->GetComponent(c, 0)),
      static_cast<std::int64_t>(pairs->GetComponent(c, 1)) };
    vtkCell* cell = grid->GetCell(c);
    for (vtkIdType p = 0; p < cell->GetNumberOfPoints(); ++p)
    {
      numbers.push_back(IdOf(grid->GetPointData()->GetGlobalIds(), cell->GetPointId(p)));
    }
  }
  return all;
}

class SculptorSplit : public ::testing::TestWithParam<int> // parameter: whether tetrahedra
{
protected:
  void SetUp() override
  {
    const HostFields f(MyRank(), NumberOfRanks());
    this->Sculptor = CreateSculptor(f);
    ASSERT_NE(this->Sculptor, 0);
    sculptor_set_option(this->Sculptor, "SplitInterfaces", "ball/plate");
    sculptor_set_option(this->Sculptor, "SplitConnection", "Cohesive");
    ASSERT_EQ(sculptor_make_mesh(this->Sculptor, GetParam()), SCULPTOR_OK)
      << sculptor_error_text(this->Sculptor);
    this->Tets->SetMethod(vtkVolumeFractionToTet::METHOD_LATTICE);
    this->Filter()->SetSplitInterfaces("1/2");
    this->Filter()->SetSplitConnection(1);
    MeshWhole(HostFields(0, 1), *this->Filter());
  }
  void TearDown() override { EXPECT_EQ(sculptor_delete(this->Sculptor), SCULPTOR_OK); }

  vtkVolumeFractionMeshAlgorithm* Filter()
  {
    return GetParam() ? static_cast<vtkVolumeFractionMeshAlgorithm*>(this->Tets) : this->Hexes;
  }

  int Sculptor = 0;
  vtkNew<vtkVolumeFractionToHex> Hexes;
  vtkNew<vtkVolumeFractionToTet> Tets;
};

} // namespace

TEST_P(SculptorSplit, CohesiveElementsAreThoseOfTheFilter)
{
  auto grid = vtkUnstructuredGrid::SafeDownCast(this->Filter()->GetOutputDataObject(5));
  const Elements expected = ElementsOf(grid);
  ASSERT_GT(expected.size(), 0u);
  EXPECT_EQ(grid->GetCellType(0), GetParam() ? VTK_WEDGE : VTK_HEXAHEDRON);
  std::int64_t count = 0;
  int corners = 0;
  const std::int64_t *connectivity = nullptr, *ids = nullptr, *pointIds = nullptr;
  const int* materials = nullptr;
  ASSERT_EQ(
    sculptor_get_cohesive(this->Sculptor, &count, &corners, &connectivity, &ids, &materials),
    SCULPTOR_OK);
  ASSERT_EQ(sculptor_get_point_ids(this->Sculptor, &pointIds), SCULPTOR_OK);
  EXPECT_EQ(corners, count == 0 ? 0 : GetParam() ? 6 : 8);
  for (std::int64_t e = 0; e < count; ++e)
  {
    Numbers numbers{ materials[2 * e], materials[2 * e + 1] };
    for (int c = 0; c < corners; ++c)
    {
      numbers.push_back(pointIds[connectivity[corners * e + c]]);
    }
    EXPECT_EQ(expected.at(ids[e]), numbers);
  }
  std::int64_t total = 0;
  MPI_Allreduce(&count, &total, 1, MPI_INT64_T, MPI_SUM, MPI_COMM_WORLD);
  EXPECT_EQ(total, static_cast<std::int64_t>(expected.size()));
}

TEST_P(SculptorSplit, NodesAreThoseOfTheFilter)
{
  vtkUnstructuredGrid* mesh = this->Filter()->GetOutput();
  std::map<std::int64_t, std::int64_t> expected; // ids before, by id
  std::int64_t added = 0;
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    const std::int64_t id = IdOf(mesh->GetPointData()->GetGlobalIds(), p);
    expected[id] = IdOf(mesh->GetPointData()->GetArray("OriginalPointIds"), p);
    added += expected[id] != id ? 1 : 0;
  }
  EXPECT_GT(added, 0);
  std::int64_t count = 0, elements = 0;
  int corners = 0;
  const std::int64_t *ids = nullptr, *originals = nullptr;
  ASSERT_EQ(sculptor_get_counts(this->Sculptor, &count, &elements, &corners), SCULPTOR_OK);
  ASSERT_EQ(sculptor_get_point_ids(this->Sculptor, &ids), SCULPTOR_OK);
  ASSERT_EQ(sculptor_get_original_ids(this->Sculptor, &originals), SCULPTOR_OK);
  for (std::int64_t p = 0; p < count; ++p)
  {
    EXPECT_EQ(expected.at(ids[p]), originals[p]);
  }
  double number = 0.0;
  ASSERT_EQ(sculptor_get_number(this->Sculptor, "AddedNodes", 0, &number), SCULPTOR_OK);
  EXPECT_EQ(number, static_cast<double>(added));
}

INSTANTIATE_TEST_SUITE_P(Kinds, SculptorSplit, ::testing::Values(0, 1));

/// Layers of the elements; none by default.
TEST(SculptorLayers, AreThoseOfTheFilter)
{
  const HostFields fields(MyRank(), NumberOfRanks()); // not copied
  const int sculptor = CreateSculptor(fields);
  ASSERT_NE(sculptor, 0);
  const int* layers = nullptr;
  ASSERT_EQ(sculptor_make_mesh(sculptor, 0), SCULPTOR_OK);
  ASSERT_EQ(sculptor_get_layers(sculptor, &layers), SCULPTOR_OK);
  EXPECT_EQ(layers, nullptr);
  sculptor_set_option(sculptor, "Layers", "3");
  ASSERT_EQ(sculptor_make_mesh(sculptor, 0), SCULPTOR_OK) << sculptor_error_text(sculptor);
  vtkNew<vtkVolumeFractionToHex> filter;
  filter->SetLayers(3);
  MeshWhole(HostFields(0, 1), *filter);
  vtkCellData* cells = filter->GetOutput()->GetCellData();
  std::map<std::int64_t, std::int64_t> expected; // layers by id
  for (vtkIdType e = 0; e < filter->GetOutput()->GetNumberOfCells(); ++e)
  {
    expected[IdOf(cells->GetGlobalIds(), e)] = IdOf(cells->GetArray("Layer"), e);
  }
  std::int64_t points = 0, count = 0, third = 0;
  int corners = 0;
  const std::int64_t* ids = nullptr;
  ASSERT_EQ(sculptor_get_counts(sculptor, &points, &count, &corners), SCULPTOR_OK);
  ASSERT_EQ(sculptor_get_element_ids(sculptor, &ids), SCULPTOR_OK);
  ASSERT_EQ(sculptor_get_layers(sculptor, &layers), SCULPTOR_OK);
  for (std::int64_t e = 0; e < count; ++e)
  {
    EXPECT_EQ(expected.at(ids[e]), layers[e]);
    third += layers[e] == 3 ? 1 : 0;
  }
  std::int64_t all = 0;
  MPI_Allreduce(&third, &all, 1, MPI_INT64_T, MPI_SUM, MPI_COMM_WORLD);
  EXPECT_GT(all, 100);
  EXPECT_EQ(sculptor_delete(sculptor), SCULPTOR_OK);
}
