/// VTK reads the data passed to Catalyst 2: the filter makes the same mesh from
/// them as from the host's boxes.
#include "CatalystAdaptor.h"
#include "CatalystDouble.h"
#include "HostImages.h"
#include "LevelBlocks.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkConduitSource.h"
#include "vtkDataArray.h"
#include "vtkMPI.h"
#include "vtkMPICommunicator.h"
#include "vtkMPIController.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolumeFractionToHex.h"

#include <catalyst_conduit.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <memory>

namespace
{

/// Receives the data of each step.
std::function<void(const conduit_cpp::Node& node)> receiver;

} // namespace

catalyst_status ReceiveFromCatalyst(const char* call, const conduit_node* node)
{
  if (call == std::string("execute"))
  {
    receiver(conduit_cpp::cpp_node(const_cast<conduit_node*>(node)));
  }
  return catalyst_status_ok;
}

namespace vfm
{
namespace testing
{
namespace
{

/// Returns a controller of all ranks, as an implementation would create it.
vtkSmartPointer<vtkMPIController> MakeController(MPI_Comm& communicator)
{
  vtkMPICommunicatorOpaqueComm handle(&communicator);
  vtkNew<vtkMPICommunicator> wrapped;
  wrapped->InitializeExternal(&handle);
  auto controller = vtkSmartPointer<vtkMPIController>::New();
  controller->SetCommunicator(wrapped);
  return controller;
}

vtkSmartPointer<vtkUnstructuredGrid> Mesh(
  vtkVolumeFractionToHex* mesher, vtkMultiProcessController* controller)
{
  mesher->SetController(controller);
  mesher->AddVolumeFractionArray("ball");
  mesher->AddVolumeFractionArray("plate");
  mesher->AddStateArray("velocity");
  mesher->Update();
  auto mesh = vtkSmartPointer<vtkUnstructuredGrid>::New();
  mesh->ShallowCopy(mesher->GetOutputDataObject(0));
  return mesh;
}

/// Returns the largest difference between two arrays; infinite if their sizes differ.
double Difference(vtkDataArray* a, vtkDataArray* b)
{
  if (!a || !b || a->GetNumberOfTuples() != b->GetNumberOfTuples() ||
    a->GetNumberOfComponents() != b->GetNumberOfComponents())
  {
    return std::numeric_limits<double>::infinity();
  }
  double most = 0.0;
  for (vtkIdType t = 0; t < a->GetNumberOfTuples(); ++t)
  {
    for (int c = 0; c < a->GetNumberOfComponents(); ++c)
    {
      most = std::max(most, std::abs(a->GetComponent(t, c) - b->GetComponent(t, c)));
    }
  }
  return most;
}

class CatalystMesh : public ::testing::Test
{
protected:
  static void SetUpTestSuite()
  {
    Catalyst = std::make_unique<CatalystAdaptor>(MPI_COMM_WORLD, std::vector<std::string>());
  }
  static void TearDownTestSuite() { Catalyst.reset(); }

  static std::unique_ptr<CatalystAdaptor> Catalyst; // one per process
};

std::unique_ptr<CatalystAdaptor> CatalystMesh::Catalyst;

/// Compares the meshes made in both ways of three levels on all ranks.
void CompareMeshes(
  CatalystAdaptor& catalyst, const Vector3& origin, const Vector3& spacing, double tolerance)
{
  MPI_Comm world = MPI_COMM_WORLD;
  int rank = 0, ranks = 1;
  MPI_Comm_rank(world, &rank);
  MPI_Comm_size(world, &ranks);
  const std::vector<Place> places = CutPlaces();
  std::vector<LevelBlock> blocks;
  for (std::size_t p = 0; p < places.size(); ++p)
  {
    if (static_cast<int>(p * p) % ranks == rank) // with three ranks, the last one has no block
    {
      blocks.emplace_back(places[p].Level, places[p].Cells, spacing);
    }
  }
  HostGrid grid{ origin, spacing, BaseCells, {} };
  for (const LevelBlock& block : blocks)
  {
    grid.Boxes.push_back({ block.Cells,
      { MakeHostArray("ball", block.Ball.data()), MakeHostArray("plate", block.Plate.data()),
        MakeHostArray("velocity", block.Velocity.data(), 3) },
      block.Level });
  }
  const auto controller = MakeController(world);
  vtkMultiProcessController::SetGlobalController(controller);
  vtkSmartPointer<vtkUnstructuredGrid> direct, received;
  {
    vtkNew<vtkVolumeFractionToHex> mesher;
    mesher->SetInputDataObject(MakeBlocks(grid, 0, static_cast<unsigned int>(grid.Boxes.size())));
    direct = Mesh(mesher, controller);
  }
  receiver = [&](const conduit_cpp::Node& node)
  {
    const conduit_cpp::Node meshes = node["catalyst/channels/input/data"];
    vtkNew<vtkConduitSource> source;
    source->SetUseMultiMeshProtocol(true);
    source->SetNode(conduit_cpp::c_node(&meshes));
    vtkNew<vtkVolumeFractionToHex> mesher;
    mesher->SetInputConnection(source->GetOutputPort());
    received = Mesh(mesher, controller);
  };
  EXPECT_TRUE(catalyst.Process(grid, 0.0, 0)) << catalyst.GetError();
  ASSERT_TRUE(received);
  ASSERT_GT(direct->GetNumberOfCells(), 0);
  EXPECT_LE(
    Difference(direct->GetPoints()->GetData(), received->GetPoints()->GetData()), tolerance);
  EXPECT_EQ(Difference(direct->GetCells()->GetConnectivityArray(),
              received->GetCells()->GetConnectivityArray()),
    0.0);
  for (const char* name : { "MaterialId", "velocity" })
  {
    EXPECT_LE(
      Difference(direct->GetCellData()->GetArray(name), received->GetCellData()->GetArray(name)),
      tolerance)
      << name;
  }
  std::printf("rank %d: %lld hexahedra, points differ by %g\n", rank,
    static_cast<long long>(direct->GetNumberOfCells()),
    Difference(direct->GetPoints()->GetData(), received->GetPoints()->GetData()));
  vtkMultiProcessController::SetGlobalController(nullptr);
}

TEST_F(CatalystMesh, TheSameBitsWhereCoordinatesAreExact)
{
  CompareMeshes(*Catalyst, { { -1.0, 0.5, 2.0 } }, { { 0.5, 0.25, 0.75 } }, 0.0);
}

/// Each box has its own origin.
TEST_F(CatalystMesh, TheSameToRoundingElsewhere)
{
  CompareMeshes(*Catalyst, { { -0.7, 0.3, 2.1 } }, { { 0.1, 0.125, 0.11 } }, 1e-8);
}

} // namespace
} // namespace testing
} // namespace vfm
