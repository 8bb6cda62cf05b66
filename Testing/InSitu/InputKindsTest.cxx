/// Every kind of data set that contains blocks and of array that contains values, distributed to
/// the ranks, gives the mesh of plain blocks.
#include "BlockHost.h"
#include "MeshView.h"
#include "VtkMessages.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkMPI.h"
#include "vtkMPICommunicator.h"
#include "vtkMPIController.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiPieceDataSet.h"
#include "vtkNonOverlappingAMR.h"
#include "vtkOverlappingAMR.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkSOADataArrayTemplate.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolumeFractionToHex.h"
#ifdef VFM_HAS_COMPUTED_ARRAYS
#include "vtkAffineArray.h"
#include "vtkConstantArray.h"
#endif

#include <gtest/gtest.h>

#include <numeric>

using namespace vfm;
using namespace vfm::testing;

namespace
{

vtkSmartPointer<vtkMPIController> MakeController()
{
  MPI_Comm world = MPI_COMM_WORLD;
  vtkMPICommunicatorOpaqueComm handle(&world);
  vtkNew<vtkMPICommunicator> ranks;
  ranks->InitializeExternal(&handle);
  auto controller = vtkSmartPointer<vtkMPIController>::New();
  controller->SetCommunicator(ranks);
  return controller;
}

/// The filter on data distributed to the ranks, with "ball" and "plate" as
/// fractions, or "id" as labels.
struct Mesher
{
  explicit Mesher(vtkDataObject* data, bool ids = false)
  {
    this->Messages.Watch(this->Filter);
    this->Filter->SetController(this->Controller);
    if (ids)
    {
      this->Filter->SetMaterialIdArray("id");
    }
    else
    {
      this->Filter->AddVolumeFractionArray("ball");
      this->Filter->AddVolumeFractionArray("plate");
    }
    this->Filter->AddStateArray("velocity");
    this->Filter->SetInputDataObject(data);
    this->Filter->Update();
  }

  std::uint64_t Digest()
  {
    EXPECT_EQ(this->Messages.GetErrorText(), "");
    vtkUnstructuredGrid* mesh = this->Filter->GetOutput();
    return SumOverRanks(mesh->GetNumberOfCells() > 0 ? vfm::testing::Digest(ViewOf(mesh)) : 0);
  }

  vtkSmartPointer<vtkMPIController> Controller = MakeController();
  vtkNew<vtkVolumeFractionToHex> Filter;
  VtkMessages Messages;
};

vtkSmartPointer<vtkDataObject> AsBlocksOfBlocks(const LevelGrids& grids)
{
  auto data = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  for (unsigned int level = 0; level < grids.size(); ++level)
  {
    vtkNew<vtkMultiBlockDataSet> blocks;
    for (unsigned int i = 0; i < grids[level].size(); ++i)
    {
      blocks->SetBlock(i, grids[level][i]);
    }
    data->SetBlock(level, blocks);
  }
  return data;
}

vtkSmartPointer<vtkDataObject> AsBlocksOfPieces(const LevelGrids& grids)
{
  auto data = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  for (unsigned int level = 0; level < grids.size(); ++level)
  {
    vtkNew<vtkMultiPieceDataSet> pieces;
    for (unsigned int i = 0; i < grids[level].size(); ++i)
    {
      pieces->SetPiece(i, grids[level][i]);
    }
    data->SetBlock(level, pieces);
  }
  return data;
}

vtkSmartPointer<vtkDataObject> AsPartitions(const LevelGrids& grids)
{
  auto data = vtkSmartPointer<vtkPartitionedDataSet>::New();
  unsigned int partition = 0;
  for (const auto& level : grids)
  {
    for (vtkUniformGrid* grid : level)
    {
      data->SetPartition(partition++, grid);
    }
  }
  return data;
}

vtkSmartPointer<vtkDataObject> AsCollection(const LevelGrids& grids)
{
  auto data = vtkSmartPointer<vtkPartitionedDataSetCollection>::New();
  for (unsigned int level = 0; level < grids.size(); ++level)
  {
    for (unsigned int i = 0; i < grids[level].size(); ++i)
    {
      data->SetPartition(level, i, grids[level][i]);
    }
  }
  return data;
}

/// Overlapping levels require more: see MakeOverlapping.
vtkSmartPointer<vtkDataObject> AsLevels(const LevelGrids& grids)
{
  auto data = vtkSmartPointer<vtkNonOverlappingAMR>::New();
  SetGrids(grids, data.Get());
  return data;
}

struct Kind
{
  const char* Name;
  vtkSmartPointer<vtkDataObject> (*Make)(const LevelGrids& grids);
};

constexpr Kind Kinds[] = { { "blocks of blocks", AsBlocksOfBlocks },
  { "blocks of pieces", AsBlocksOfPieces }, { "partitions", AsPartitions },
  { "collection", AsCollection }, { "levels", AsLevels } };

std::uint64_t DigestOfHost(const std::vector<Place>& places, bool ids = false)
{
  Host host;
  host.Distribute(places, Binary, Distribute::InTurn);
  host.HandOver(ids);
  return host.Mesh();
}

LevelGrids Distributed(const std::vector<Place>& places)
{
  return MakeGrids(places, Binary, MyRank(), NumberOfRanks());
}

/// Replaces an array by one that stores each component separately.
template <class T>
void SetByComponents(vtkCellData* arrays, const char* name)
{
  auto array = vtkSmartPointer<vtkSOADataArrayTemplate<T>>::New();
  array->DeepCopy(arrays->GetArray(name));
  array->SetName(name);
  arrays->AddArray(array);
}

} // namespace

TEST(InputKinds, CompositeDataSets)
{
  for (const std::vector<Place>& places : { NestedPlaces(), LeafPlaces() })
  {
    const std::uint64_t expected = DigestOfHost(places);
    for (const Kind& kind : Kinds)
    {
      EXPECT_EQ(Mesher(kind.Make(Distributed(places))).Digest(), expected) << kind.Name;
    }
    const auto overlapping = MakeOverlapping(places, Binary, MyRank(), NumberOfRanks());
    EXPECT_EQ(Mesher(overlapping).Digest(), expected);
  }
}

/// Some readers load few levels by default.
TEST(InputKinds, LevelsThatAreNotLoaded)
{
  LevelGrids grids = Distributed(NestedPlaces());
  std::fill(grids[1].begin(), grids[1].end(), nullptr);
  std::fill(grids[2].begin(), grids[2].end(), nullptr);
  const Mesher mesher(AsLevels(grids));
  std::string text;
  for (const std::string& warning : mesher.Messages.GetWarnings())
  {
    text += warning;
  }
  const bool tells = text.find("boxes without data on level 1, 2.") != std::string::npos;
  EXPECT_EQ(tells, MyRank() == 0) << text;
}

TEST(InputKinds, ArraysByComponents)
{
  for (bool ids : { false, true })
  {
    const LevelGrids grids = Distributed(NestedPlaces());
    for (const auto& level : grids)
    {
      for (vtkUniformGrid* grid : level)
      {
        if (grid)
        {
          SetByComponents<double>(grid->GetCellData(), "ball");
          SetByComponents<double>(grid->GetCellData(), "plate");
          SetByComponents<double>(grid->GetCellData(), "velocity");
          SetByComponents<int>(grid->GetCellData(), "id");
        }
      }
    }
    EXPECT_EQ(Mesher(AsPartitions(grids), ids).Digest(), DigestOfHost(NestedPlaces(), ids));
  }
}

/// A layer of ghost cells; the array of ghost types stores components separately.
TEST(InputKinds, GhostTypesByComponents)
{
  const std::vector<Place> places{ { 0, { { { 0, 0, 0 } }, { { 3, 4, 5 } } } },
    { 0, { { { 3, 0, 0 } }, BaseCells } } };
  std::vector<Place> overlapping = places;
  overlapping[1].Cells.Lower[0] -= 1;
  const LevelGrids grids = Distributed(overlapping);
  if (vtkUniformGrid* grid = grids[0][1])
  {
    vtkNew<vtkUnsignedCharArray> types;
    types->SetName(vtkDataSetAttributes::GhostArrayName());
    types->SetNumberOfValues(grid->GetNumberOfCells());
    for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
    {
      types->SetValue(cell, cell % 4 == 0 ? vtkDataSetAttributes::DUPLICATECELL : 0);
    }
    grid->GetCellData()->AddArray(types);
    SetByComponents<unsigned char>(grid->GetCellData(), vtkDataSetAttributes::GhostArrayName());
  }
  EXPECT_EQ(Mesher(AsPartitions(grids)).Digest(), DigestOfHost(places));
}

#ifdef VFM_HAS_COMPUTED_ARRAYS
/// All cells have one material; the mesh equals that of arrays in memory.
TEST(InputKinds, ArraysThatComputeTheirValues)
{
  for (bool ids : { false, true })
  {
    std::array<std::uint64_t, 2> digests{};
    for (bool inMemory : { false, true })
    {
      const LevelGrids grids = Distributed({ { 0, { { { 0, 0, 0 } }, BaseCells } } });
      if (vtkUniformGrid* grid = grids[0][0])
      {
        const vtkIdType cells = grid->GetNumberOfCells();
        vtkNew<vtkConstantArray<unsigned char>> ball;
        ball->ConstructBackend(255); // fractions in bytes
        vtkNew<vtkConstantArray<float>> plate;
        plate->ConstructBackend(0.0f);
        vtkNew<vtkConstantArray<int>> id;
        id->ConstructBackend(7);
        vtkNew<vtkAffineArray<double>> velocity;
        velocity->ConstructBackend(2.0, 1.0);
        velocity->SetNumberOfComponents(3);
        const std::array<std::pair<const char*, vtkDataArray*>, 4> arrays{ { { "ball", ball },
          { "plate", plate }, { "id", id }, { "velocity", velocity } } };
        for (const auto& array : arrays)
        {
          array.second->SetNumberOfTuples(cells);
          array.second->SetName(array.first);
          vtkSmartPointer<vtkDataArray> added = array.second;
          if (inMemory)
          {
            added.TakeReference(vtkDataArray::CreateDataArray(added->GetDataType()));
            added->DeepCopy(array.second);
          }
          grid->GetCellData()->AddArray(added);
        }
      }
      digests[inMemory] = Mesher(AsPartitions(grids), ids).Digest();
    }
    EXPECT_NE(digests[0], 0u);
    EXPECT_EQ(digests[0], digests[1]) << ids;
  }
}
#endif
