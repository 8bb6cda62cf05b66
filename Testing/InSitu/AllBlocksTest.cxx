/// HostImages: the data that ParaView receives for a grid of two levels.
#include "HostImages.h"

#include "vtkCellData.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

namespace vfm
{
namespace testing
{
namespace
{

constexpr unsigned char Ghost = 1, Hidden = 32;

/// Two boxes that form level 0 of 4 x 4 x 2 cells, and one of level 1 over [1,3) x [1,3) x [0,1)
/// with a layer of ghost cells towards +x.
struct Host
{
  std::vector<double> Values = std::vector<double>(64, 0.5);
  std::vector<unsigned char> Right, Fine;

  Host() : Right(16, 0), Fine(5 * 4 * 2, 0)
  {
    this->Right[15] = Ghost << 1;
    for (std::size_t row = 0; row < this->Fine.size(); row += 5)
    {
      this->Fine[row + 4] = Ghost;
    }
  }

  HostGrid Describe() const
  {
    const HostArray values = MakeHostArray("values", this->Values.data());
    HostGrid grid{ { { 0, 0, 0 } }, { { 1, 1, 1 } }, { { 4, 4, 2 } }, {} };
    grid.Boxes.push_back({ { { { 0, 0, 0 } }, { { 2, 4, 2 } } }, { values } });
    grid.Boxes.push_back({ { { { 2, 0, 0 } }, { { 4, 4, 2 } } },
      { values, MakeHostArray("vtkGhostType", this->Right.data()) } });
    grid.Boxes.push_back({ { { { 2, 2, 0 } }, { { 7, 6, 2 } } },
      { values, MakeHostArray("vtkGhostType", this->Fine.data()) }, 1 });
    return grid;
  }
};

vtkUnsignedCharArray* TypesOf(vtkMultiBlockDataSet* blocks, unsigned int block)
{
  return vtkImageData::SafeDownCast(blocks->GetBlock(block))->GetCellGhostArray();
}

TEST(AllBlocks, CellsBelowFinerOnesAreHidden)
{
  const Host host;
  Ranks alone;
  const vtkSmartPointer<vtkMultiBlockDataSet> blocks = MakeAllBlocks(host.Describe(), alone);
  ASSERT_EQ(blocks->GetNumberOfBlocks(), 3u);
  for (unsigned int b = 0; b < 2; ++b)
  {
    vtkUnsignedCharArray* types = TypesOf(blocks, b);
    ASSERT_NE(types, nullptr);
    for (int cell = 0; cell < 16; ++cell)
    {
      const int i = cell % 2, j = cell / 2 % 4, k = cell / 8;
      // ghost cells hide no cells
      const bool covered = i == (b ? 0 : 1) && (j == 1 || j == 2) && k == 0;
      const int own = b ? host.Right[cell] : 0;
      EXPECT_EQ(types->GetValue(cell), covered ? Hidden : own) << b << " " << cell;
    }
  }
  EXPECT_EQ(TypesOf(blocks, 2)->GetPointer(0), host.Fine.data());
  EXPECT_EQ(host.Right[0], 0); // the host's memory is unchanged
}

TEST(AllBlocks, OneLevelIsOnlyTheHostsMemory)
{
  const Host host;
  HostGrid grid = host.Describe();
  grid.Boxes.pop_back();
  Ranks alone;
  const vtkSmartPointer<vtkMultiBlockDataSet> blocks = MakeAllBlocks(grid, alone);
  EXPECT_EQ(TypesOf(blocks, 0), nullptr);
  EXPECT_EQ(TypesOf(blocks, 1)->GetPointer(0), host.Right.data());
}

} // namespace
} // namespace testing
} // namespace vfm
