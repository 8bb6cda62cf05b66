/**
 * Reads a voxel file with the suffix VFM_FUZZ_SUFFIX: all cells, and the last one.
 */
#include "Harness.h"

#include "ReadVoxels.h"

namespace vfm
{
namespace testing
{
namespace
{

constexpr double Small = 4e6;     // cells that a run may read
constexpr double Overflow = 9e18; // a number of cells that no reader may accept

} // namespace

void ReadBytes(const std::string& bytes)
{
  const std::string path = WriteInput(std::string("a") + VFM_FUZZ_SUFFIX, bytes);
  const Index3 ofText{ { 4, 3, 2 } };
  for (const AxisOrder order : { AxisOrder::XYZ, AxisOrder::ZXY })
  {
    const VoxelFile file = InspectVoxels(path, IsNumPyFile(path) ? Index3{} : ofText, order);
    const Index3& size = file.Cells;
    const double count =
      static_cast<double>(size[0]) * static_cast<double>(size[1]) * static_cast<double>(size[2]);
    if (count < Small || count > Overflow)
    {
      ReadVoxels(file, { { { 0, 0, 0 } }, size });
    }
    ReadVoxels(file, { { { size[0] - 1, size[1] - 1, size[2] - 1 } }, size });
  }
}

} // namespace testing
} // namespace vfm
