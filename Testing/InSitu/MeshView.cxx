#include "MeshView.h"
#include "ArrayMemory.h"
#include "Sculptor.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>
#include <mpi.h>

#include <cstring>

namespace vfm
{
namespace testing
{
namespace
{

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

template <class T>
const T* Values(vtkDataArray* array)
{
  return static_cast<const T*>(FindMemory(array));
}

} // namespace

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

std::uint64_t SumOverRanks(std::uint64_t mine)
{
  std::uint64_t sum = 0;
  MPI_Allreduce(&mine, &sum, 1, MPI_UINT64_T, MPI_SUM, MPI_COMM_WORLD);
  return sum;
}

} // namespace testing
} // namespace vfm
