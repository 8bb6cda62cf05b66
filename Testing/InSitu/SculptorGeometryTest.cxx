/// Surfaces, curves and vertices from the C interface on several ranks
/// equal the filter's on one rank.
#include "HostFields.h"
#include "Sculptor.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolumeFractionToHex.h"
#include "vtkVolumeFractionToTet.h"

#include <gtest/gtest.h>

#include <map>

using namespace vfm;
using namespace vfm::testing;

namespace
{

/// Number of the surface, curve or vertex of each cell, by the global ids of its points.
using Cells = std::map<std::vector<std::int64_t>, int>;
/// Dimension and number by global id.
using Classified = std::map<std::int64_t, std::array<int, 2>>;

Cells CellsOfPort(vtkPolyData* data, vtkCellArray* cells)
{
  auto ids = vtkIdTypeArray::SafeDownCast(data->GetPointData()->GetGlobalIds());
  Cells all;
  for (vtkIdType c = 0; c < cells->GetNumberOfCells(); ++c)
  {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    cells->GetCellAtId(c, size, corners);
    std::vector<std::int64_t> points;
    for (vtkIdType p = 0; p < size; ++p)
    {
      points.push_back(ids->GetValue(corners[p]));
    }
    all[points] = static_cast<int>(data->GetCellData()->GetScalars()->GetComponent(c, 0));
  }
  return all;
}

/// Returns the lists of all ranks joined; each may have another length.
std::vector<std::int64_t> GatherNumbers(const std::vector<std::int64_t>& mine)
{
  const int count = static_cast<int>(mine.size());
  std::vector<int> counts(NumberOfRanks()), places(NumberOfRanks(), 0);
  MPI_Allgather(&count, 1, MPI_INT, counts.data(), 1, MPI_INT, MPI_COMM_WORLD);
  for (std::size_t r = 1; r < places.size(); ++r)
  {
    places[r] = places[r - 1] + counts[r - 1];
  }
  std::vector<std::int64_t> all(places.back() + counts.back());
  MPI_Allgatherv(mine.data(), count, MPI_INT64_T, all.data(), counts.data(), places.data(),
    MPI_INT64_T, MPI_COMM_WORLD);
  return all;
}

/// Returns the cells of all ranks; each must be on exactly one rank.
Cells GatherCells(std::int64_t count, int corners, const std::int64_t* connectivity, const int* ids,
  const std::int64_t* pointIds)
{
  std::vector<std::int64_t> mine;
  for (std::int64_t c = 0; c < count; ++c)
  {
    mine.push_back(ids[c]);
    for (int p = 0; p < corners; ++p)
    {
      mine.push_back(pointIds[connectivity[corners * c + p]]);
    }
  }
  std::int64_t most = corners; // 0 on a rank without cells
  MPI_Allreduce(MPI_IN_PLACE, &most, 1, MPI_INT64_T, MPI_MAX, MPI_COMM_WORLD);
  const std::vector<std::int64_t> all = GatherNumbers(mine);
  Cells cells;
  for (auto at = all.begin(); at != all.end(); at += 1 + most)
  {
    EXPECT_TRUE(
      cells.emplace(std::vector<std::int64_t>(at + 1, at + 1 + most), static_cast<int>(*at))
        .second);
  }
  return cells;
}

class SculptorGeometry : public ::testing::TestWithParam<int> // parameter: whether tetrahedra
{
protected:
  void SetUp() override
  {
    const HostFields f(MyRank(), NumberOfRanks());
    this->Sculptor = CreateSculptor(f);
    ASSERT_NE(this->Sculptor, 0);
    ASSERT_EQ(sculptor_make_mesh(this->Sculptor, GetParam()), SCULPTOR_OK)
      << sculptor_error_text(this->Sculptor);
    this->Tets->SetMethod(vtkVolumeFractionToTet::METHOD_LATTICE);
    MeshWhole(HostFields(0, 1), *this->Filter());
    ASSERT_EQ(sculptor_get_point_ids(this->Sculptor, &this->PointIds), SCULPTOR_OK);
  }
  void TearDown() override { EXPECT_EQ(sculptor_delete(this->Sculptor), SCULPTOR_OK); }

  vtkVolumeFractionMeshAlgorithm* Filter()
  {
    return GetParam() ? static_cast<vtkVolumeFractionMeshAlgorithm*>(this->Tets) : this->Hexes;
  }
  vtkPolyData* Port(int port)
  {
    return vtkPolyData::SafeDownCast(this->Filter()->GetOutputDataObject(port));
  }

  int Sculptor = 0;
  const std::int64_t* PointIds = nullptr;
  vtkNew<vtkVolumeFractionToHex> Hexes;
  vtkNew<vtkVolumeFractionToTet> Tets;
};

} // namespace

TEST_P(SculptorGeometry, PointsAreClassified)
{
  const int *dimensions = nullptr, *ids = nullptr;
  ASSERT_EQ(sculptor_get_geometry(this->Sculptor, &dimensions, &ids), SCULPTOR_OK);
  vtkPointData* points = this->Filter()->GetOutput()->GetPointData();
  Classified expected;
  for (vtkIdType p = 0; p < this->Filter()->GetOutput()->GetNumberOfPoints(); ++p)
  {
    const auto number = [&](const char* name)
    { return static_cast<int>(points->GetArray(name)->GetComponent(p, 0)); };
    expected[static_cast<std::int64_t>(points->GetGlobalIds()->GetComponent(p, 0))] = {
      { number("GeometryDimension"), number("GeometryId") }
    };
  }
  std::int64_t count = 0, elements = 0;
  int corners = 0;
  ASSERT_EQ(sculptor_get_counts(this->Sculptor, &count, &elements, &corners), SCULPTOR_OK);
  ASSERT_GT(count, 0);
  for (std::int64_t p = 0; p < count; ++p)
  {
    const std::array<int, 2> own{ { dimensions[p], ids[p] } };
    EXPECT_EQ(expected.at(this->PointIds[p]), own);
  }
}

TEST_P(SculptorGeometry, CellsAreThoseOfTheFilter)
{
  std::int64_t count = 0;
  int corners = 0;
  const std::int64_t* connectivity = nullptr;
  const int* ids = nullptr;
  ASSERT_EQ(
    sculptor_get_surfaces(this->Sculptor, &count, &corners, &connectivity, &ids), SCULPTOR_OK);
  EXPECT_EQ(corners, count == 0 ? 0 : GetParam() ? 3 : 4);
  const Cells facets = GatherCells(count, corners, connectivity, ids, this->PointIds);
  EXPECT_EQ(facets, CellsOfPort(this->Port(1), this->Port(1)->GetPolys()));
  EXPECT_GT(facets.size(), 0u);
  ASSERT_EQ(sculptor_get_curves(this->Sculptor, &count, &connectivity, &ids), SCULPTOR_OK);
  const Cells edges = GatherCells(count, 2, connectivity, ids, this->PointIds);
  EXPECT_EQ(edges, CellsOfPort(this->Port(2), this->Port(2)->GetLines()));
  EXPECT_GT(edges.size(), 0u);
  ASSERT_EQ(sculptor_get_vertices(this->Sculptor, &count, &connectivity, &ids), SCULPTOR_OK);
  const Cells vertices = GatherCells(count, 1, connectivity, ids, this->PointIds);
  EXPECT_EQ(vertices, CellsOfPort(this->Port(3), this->Port(3)->GetVerts()));
  EXPECT_GT(vertices.size(), 0u);
}

TEST_P(SculptorGeometry, TablesAreThoseOfTheFilter)
{
  int tables = 0;
  for (int port = 1; port <= 3; ++port)
  {
    vtkFieldData* field = this->Port(port)->GetFieldData();
    for (int t = 0; t < field->GetNumberOfArrays(); ++t)
    {
      auto expected = vtkIntArray::SafeDownCast(field->GetArray(t));
      if (!expected)
      {
        continue; // areas, centroids, normals
      }
      ++tables;
      int rows = 0, columns = 0;
      const int* values = nullptr;
      ASSERT_EQ(
        sculptor_get_bounds(this->Sculptor, field->GetArrayName(t), &rows, &columns, &values),
        SCULPTOR_OK);
      EXPECT_EQ(columns, expected->GetNumberOfComponents());
      ASSERT_GT(rows, 0) << field->GetArrayName(t);
      EXPECT_EQ(std::vector<int>(values, values + rows * columns),
        std::vector<int>(
          expected->GetPointer(0), expected->GetPointer(0) + expected->GetNumberOfValues()));
    }
  }
  EXPECT_EQ(tables, 8);
}

TEST_P(SculptorGeometry, WrongArguments)
{
  int rows = 0, columns = 0;
  const int* values = nullptr;
  std::int64_t count = 0;
  EXPECT_EQ(sculptor_get_bounds(this->Sculptor, "Bounds", &rows, &columns, &values),
    SCULPTOR_ERROR_ARGUMENT);
  EXPECT_NE(std::string(sculptor_error_text(this->Sculptor)).find("'Bounds'"), std::string::npos);
  EXPECT_EQ(sculptor_get_bounds(this->Sculptor, nullptr, &rows, &columns, &values),
    SCULPTOR_ERROR_ARGUMENT);
  EXPECT_EQ(sculptor_get_curves(this->Sculptor, &count, nullptr, &values), SCULPTOR_ERROR_ARGUMENT);
  int empty = 0;
  ASSERT_EQ(sculptor_create(&empty), SCULPTOR_OK);
  EXPECT_EQ(sculptor_get_geometry(empty, &values, &values), SCULPTOR_ERROR_NO_MESH);
  EXPECT_EQ(
    sculptor_get_bounds(empty, "CurveEnds", &rows, &columns, &values), SCULPTOR_ERROR_NO_MESH);
  EXPECT_EQ(sculptor_delete(empty), SCULPTOR_OK);
}

INSTANTIATE_TEST_SUITE_P(Kinds, SculptorGeometry, ::testing::Values(0, 1));
