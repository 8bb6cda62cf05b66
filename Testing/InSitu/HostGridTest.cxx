/**
 * HostGrid: VTK data in the host's memory with the same structure on every rank, and
 * clear errors for invalid grids.
 */
#include "ArrayMemory.h"
#include "Base/Runtime.h"
#include "HostImages.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

namespace vfm
{
namespace testing
{
namespace
{

/// One box, cells [2,5) x [0,2) x [1,3) of a grid of 8 x 4 x 3.
struct Host
{
  std::vector<double> Doubles = std::vector<double>(12, 0.5);
  std::vector<float> Floats = std::vector<float>(36, 0.25f);
  std::vector<int> Ints = std::vector<int>(12, 7);
  std::vector<unsigned char> Bytes = std::vector<unsigned char>(12, 255);

  HostGrid Describe() const
  {
    HostGrid grid{ { { 0.1, -3.0, 1e3 } }, { { 0.1, 0.7, 0.3 } }, { { 8, 4, 3 } }, {} };
    grid.Boxes.push_back({ { { { 2, 0, 1 } }, { { 5, 2, 3 } } },
      { MakeHostArray("doubles", Doubles.data()), MakeHostArray("floats", Floats.data(), 3),
        MakeHostArray("ints", Ints.data()), MakeHostArray("bytes", Bytes.data()) } });
    return grid;
  }
};

vtkSmartPointer<vtkImageData> MakeImage(HostGrid grid, const HostBox& box)
{
  grid.Boxes = { box };
  return vtkImageData::SafeDownCast(MakeBlocks(grid, 0, 1)->GetBlock(0));
}

void ExpectError(const std::function<void(HostGrid&)>& change, const std::string& part)
{
  const Host host;
  HostGrid grid = host.Describe();
  change(grid);
  try
  {
    MakeBlocks(grid, 0, 1);
    FAIL() << "no error about " << part;
  }
  catch (const InputError& error)
  {
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
}

TEST(HostGrid, ImageIsTheHostsMemory)
{
  const Host host;
  const HostGrid grid = host.Describe();
  const vtkSmartPointer<vtkImageData> image = MakeImage(grid, grid.Boxes[0]);
  ASSERT_EQ(image->GetNumberOfCells(), 12);
  const void* values[4] = { host.Doubles.data(), host.Floats.data(), host.Ints.data(),
    host.Bytes.data() };
  ASSERT_EQ(image->GetCellData()->GetNumberOfArrays(), 4);
  for (int i = 0; i < 4; ++i)
  {
    vtkDataArray* array = image->GetCellData()->GetArray(i);
    EXPECT_EQ(FindMemory(array), values[i]) << array->GetName();
    EXPECT_EQ(array->GetNumberOfTuples(), 12) << array->GetName();
    EXPECT_EQ(array->GetNumberOfComponents(), i == 1 ? 3 : 1) << array->GetName();
  }
}

TEST(HostGrid, ExtentsCountTheNodesOfTheWholeGrid)
{
  const Host host;
  const HostGrid grid = host.Describe();
  const vtkSmartPointer<vtkImageData> image = MakeImage(grid, grid.Boxes[0]);
  const int extent[6] = { 2, 5, 0, 2, 1, 3 };
  double point[3];
  image->GetPoint(0, point);
  for (int a = 0; a < 3; ++a)
  {
    EXPECT_EQ(image->GetExtent()[2 * a], extent[2 * a]);
    EXPECT_EQ(image->GetExtent()[2 * a + 1], extent[2 * a + 1]);
    EXPECT_EQ(image->GetOrigin()[a], grid.Origin[a]);
    EXPECT_EQ(point[a], grid.Origin[a] + extent[2 * a] * grid.Spacing[a]);
  }
}

/// Nodes of level 0 are bitwise identical on all levels, for any widths.
TEST(HostGrid, LevelsHalveTheCells)
{
  const Host host;
  HostGrid grid = host.Describe();
  for (int level : { 1, 4 })
  {
    HostBox box = grid.Boxes[0];
    box.Level = level;
    const Index step = Index(1) << level;
    box.Cells = { { { 2 * step, 0, step } }, { { 2 * step + 3, 2, step + 2 } } };
    const vtkSmartPointer<vtkImageData> coarse = MakeImage(grid, grid.Boxes[0]),
                                        fine = MakeImage(grid, box);
    double points[2][3];
    coarse->GetPoint(0, points[0]);
    fine->GetPoint(0, points[1]);
    for (int a = 0; a < 3; ++a)
    {
      EXPECT_EQ(fine->GetSpacing()[a] * static_cast<double>(step), grid.Spacing[a]);
      EXPECT_EQ(fine->GetExtent()[2 * a], box.Cells.Lower[a]);
      EXPECT_EQ(points[1][a], points[0][a]);
    }
    EXPECT_EQ(FindMemory(fine->GetCellData()->GetArray("doubles")), host.Doubles.data());
  }
}

TEST(HostGrid, BlocksOfOtherRanksAreNull)
{
  const Host host;
  const vtkSmartPointer<vtkMultiBlockDataSet> blocks = MakeBlocks(host.Describe(), 2, 4);
  ASSERT_EQ(blocks->GetNumberOfBlocks(), 4u);
  for (unsigned int b = 0; b < 4; ++b)
  {
    EXPECT_EQ(blocks->GetBlock(b) != nullptr, b == 2);
  }
}

TEST(HostGrid, ReportsWhatIsWrong)
{
  ExpectError([](HostGrid& g) { g.Origin[1] = std::numeric_limits<double>::infinity(); },
    "origin of the grid along y is not finite");
  ExpectError([](HostGrid& g) { g.Spacing[2] = 0.0; }, "spacing of the grid along z is 0");
  ExpectError([](HostGrid& g) { g.Spacing[0] = std::numeric_limits<double>::quiet_NaN(); },
    "spacing of the grid along x");
  ExpectError([](HostGrid& g) { g.Cells[1] = 0; }, "0 cells along y");
  ExpectError([](HostGrid& g) { g.Cells[0] = Index(1) << 31; }, "2147483648 cells along x");
  ExpectError([](HostGrid& g) { g.Boxes[0].Cells.Upper[0] = 2; },
    "[2, 2) x [0, 2) x [1, 3) is empty along x");
  ExpectError([](HostGrid& g) { g.Boxes[0].Cells.Upper[2] = 4; }, "leaves the grid along z");
  ExpectError([](HostGrid& g) { g.Boxes[0].Cells.Lower[0] = -1; }, "leaves the grid along x");
  ExpectError([](HostGrid& g) { g.Boxes[0].Level = -1; }, "of level -1: the level must be 0");
  ExpectError([](HostGrid& g) { g.Boxes[0].Level = 31; }, "of level 31: the level must be 0");
  ExpectError(
    [](HostGrid& g)
    {
      g.Boxes[0].Level = 2;
      g.Boxes[0].Cells.Upper[2] = 13;
    },
    "of level 2 leaves the grid along z, which has 12 cells there");
  ExpectError(
    [](HostGrid& g)
    {
      g.Boxes[0].Level = 30;
      g.Boxes[0].Cells.Lower[0] = (Index(1) << 31) - 4;
      g.Boxes[0].Cells.Upper[0] = (Index(1) << 31) - 1;
    },
    "has cells with indices above 2147483647 along x");
  ExpectError([](HostGrid& g) { g.Boxes[0].Arrays[0].Name = ""; }, "array without a name");
  ExpectError([](HostGrid& g) { g.Boxes[0].Arrays[1].Values = nullptr; }, "'floats' has no values");
  ExpectError([](HostGrid& g) { g.Boxes[0].Arrays[2].Components = 0; }, "'ints' has 0 components");
  ExpectError([](HostGrid& g) { g.Boxes[0].Arrays[3].Name = "ints"; }, "two arrays named 'ints'");
}

} // namespace
} // namespace testing
} // namespace vfm
