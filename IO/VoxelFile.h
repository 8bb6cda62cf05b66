/**
 * VoxelFile: type, size and axes of a file with one value per cell, before its values are read.
 *
 * Text (.spn), the voxel format of Sculpt: integers separated by white space, without a header.
 * NumPy (.npy): 3-D arrays of integers or fractions, or 4-D arrays (material, axes) of fractions.
 */
#pragma once

#include "Base/CartesianGrid.h"
#include "NumPyHeader.h"

#include <array>
#include <optional>
#include <string>

namespace vfm
{

/// Order of the axes as indices of an array a[.][.][.]; in text, from the slowest axis to the
/// fastest. Numbers and default equal Sculpt's spn_xyz_order (`sculpt --help --spn_xyz_order`: "for
/// i<nx, for j<ny, for k<nz, read next value"; as printed in autotwin/mesh, doc/npy_to_mesh.md).
/// The tool automesh differs for text: it reads and writes .spn with x fastest, ZYX, but .npy as
/// a[x][y][z], XYZ.
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

/// Layout of a voxel file.
struct VoxelFile
{
  std::string Path;
  Index3 Cells{}; ///< number of cells along x, y and z; 0 if unknown
  /// Axes (0 x, 1 y, 2 z) of the values in the file, from the slowest to the fastest.
  std::array<int, 3> Axes{ { 0, 1, 2 } };
  bool AreAnyNumbers = false;       ///< negative integers are accepted: values, not labels
  std::optional<NumPyHeader> NumPy; ///< header of a .npy file; empty for text
  /// Returns whether the values are volume fractions; otherwise they are labels.
  bool IsFractions() const { return this->NumPy && this->NumPy->Kind == 'f'; }
};

/// Tests whether the suffix is .npy, in lower or upper case.
bool IsNumPyFile(const std::string& path);

/// Determines the layout of a voxel file without reading its values.
/// @param path  file; the suffix .npy means NumPy, any other text
/// @param cells  number of cells along x, y and z of a text, 0 if unknown; a NumPy file has its own
/// @param order  order of the axes
/// @throws InputError  if the file cannot be read, is not a NumPy file, is truncated or too long,
///   or has a type or shape that is not an image; the message does not contain the path
VoxelFile InspectVoxels(const std::string& path, const Index3& cells, AxisOrder order);

/// Returns the numbers of cells as text, for instance "20 x 20 x 30".
std::string DescribeCells(const Index3& cells);

} // namespace vfm
