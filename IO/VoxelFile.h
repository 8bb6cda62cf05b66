/**
 * VoxelFile: what is known of a file of one value a cell before its values are read.
 *
 * Text (.spn), the voxels of Sculpt: whole numbers with any white space between them, no header. NumPy (.npy): 3-D arrays of
 * whole numbers or of fractions, or 4-D arrays (material, then the axes) of fractions.
 */
#pragma once

#include "Base/CartesianGrid.h"
#include "NumPyHeader.h"

#include <array>
#include <optional>
#include <string>

namespace vfm
{

/// The axes as the indices of an array a[.][.][.] name them, that is in text from the one that changes slowest to the one that
/// changes fastest. Numbers and default are those of Sculpt's spn_xyz_order (`sculpt --help --spn_xyz_order`: "for i<nx, for
/// j<ny, for k<nz, read next value"; as printed in autotwin/mesh, doc/npy_to_mesh.md). The program automesh disagrees
/// in text: it reads and writes .spn with x fastest, ZYX, but .npy as a[x][y][z], XYZ.
enum class AxisOrder
{
  XYZ,
  XZY,
  YXZ,
  YZX,
  ZXY,
  ZYX
};
constexpr int NumberOfAxisOrders = 6;

struct VoxelFile
{
  std::string Path;
  Index3 Cells{}; ///< along x, y and z; 0: not told
  std::array<int, 3> Axes{ { 0, 1,
    2 } }; ///< 0 x, 1 y, 2 z; from the slowest to the fastest as the values follow each other
  std::optional<NumPyHeader> NumPy; ///< nothing: text
  bool IsFractions() const { return this->NumPy && this->NumPy->Kind == 'f'; }
};

/// By its suffix, .npy in lower or upper case.
bool IsNumPyFile(const std::string& path);

/// cells: of text, a NumPy file tells its own. Reads no values. Throws InputError, without the path: the file cannot be
/// read, is no NumPy file, cut short or too long, or of a type or shape that is no image.
VoxelFile InspectVoxels(const std::string& path, const Index3& cells, AxisOrder order);

/// "20 x 20 x 30"
std::string DescribeCells(const Index3& cells);

} // namespace vfm
