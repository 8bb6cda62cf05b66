#include "VoxelFile.h"

#include "Base/Runtime.h"
#include "CellCount.h"
#include "FileSuffix.h"
#include "OpenFile.h"

#include <algorithm>
#include <limits>

namespace vfm
{
namespace
{

constexpr std::array<std::array<int, 3>, NumberOfAxisOrders> Orders{ { { { 0, 1, 2 } },
  { { 0, 2, 1 } }, { { 1, 0, 2 } }, { { 1, 2, 0 } }, { { 2, 0, 1 } }, { { 2, 1, 0 } } } };

std::string DescribeShape(const std::vector<Index>& shape)
{
  std::string text;
  for (Index size : shape)
  {
    text += (text.empty() ? "" : ", ") + std::to_string(size);
  }
  return "(" + text + (shape.size() == 1 ? ",)" : ")");
}

void CheckType(const NumPyHeader& header)
{
  const bool isInteger = header.Kind == 'u' || header.Kind == 'i';
  const bool isWhole =
    isInteger && (header.Size == 1 || header.Size == 2 || header.Size == 4 || header.Size == 8);
  const bool isReal = header.Kind == 'f' && (header.Size == 4 || header.Size == 8);
  if (header.Kind == 'O')
  {
    throw InputError(
      "it holds Python objects. Save an array of numbers, such as a.astype('uint16').");
  }
  if (!isWhole && !isReal && !(header.Kind == 'b' && header.Size == 1))
  {
    throw InputError("its values are of the NumPy type " +
      (header.Type.empty() ? std::string("with fields") : "'" + header.Type + "'") +
      ". Supported types: bool, integers of 1 to 8 bytes, floating point of 4 or 8 bytes.");
  }
}

void CheckShape(const NumPyHeader& header)
{
  const std::string shape = "its array has the shape " + DescribeShape(header.Shape);
  if (header.Shape.size() == 4 && header.Kind == 'f')
  {
    if (header.Fortran)
    {
      throw InputError(shape +
        " in Fortran order. 4-D arrays must be in C order: save numpy.ascontiguousarray(a).");
    }
  }
  else if (header.Shape.size() != 3)
  {
    throw InputError(shape + ". A 3-D array with one value per cell is required" +
      ", or a 4-D array of real numbers whose first index is the material" +
      (header.Shape.size() == 4 ? ": save a.astype('float32') of masks, or one 3-D array a[0]."
                                : "."));
  }
  for (Index size : header.Shape)
  {
    if (size < 1 || size > std::numeric_limits<int>::max() - 1)
    {
      throw InputError(shape + (size < 1 ? ", which has no cells." : ", which is too large."));
    }
  }
}

/// Checks that the values fill the rest of the file.
void CheckLength(const std::string& path, const NumPyHeader& header)
{
  const Index there = GetFileLength(path) - header.Offset;
  Index requested = header.Size;
  for (Index size : header.Shape)
  {
    // On overflow the largest Index is used, which differs from the length of every file.
    requested = requested > std::numeric_limits<Index>::max() / size
      ? std::numeric_limits<Index>::max()
      : requested * size;
  }
  if (there != requested)
  {
    throw InputError("an array of shape " + DescribeShape(header.Shape) + " and type '" +
      header.Type + "' has " + std::to_string(requested) + " bytes, but the file " +
      (there < requested ? "is truncated: it holds " : "holds ") + std::to_string(there) +
      " after its header.");
  }
}

} // namespace

bool IsNumPyFile(const std::string& path)
{
  return HasSuffix(path, ".npy");
}

VoxelFile InspectVoxels(const std::string& path, const Index3& cells, AxisOrder order)
{
  VoxelFile file;
  file.Path = path;
  file.Axes = Orders[static_cast<std::size_t>(order)];
  if (!IsNumPyFile(path))
  {
    OpenFile(path);
    CountCells(cells);
    file.Cells = cells;
    return file;
  }
  file.NumPy = ReadNumPyHeader(path);
  CheckType(*file.NumPy);
  CheckShape(*file.NumPy);
  CheckLength(path, *file.NumPy);
  for (int i = 0; i < 3; ++i)
  {
    file.Cells[file.Axes[i]] = file.NumPy->Shape[file.NumPy->Shape.size() - 3 + i];
  }
  if (file.NumPy->Fortran)
  {
    std::reverse(file.Axes.begin(), file.Axes.end());
  }
  return file;
}

std::string DescribeCells(const Index3& cells)
{
  return std::to_string(cells[0]) + " x " + std::to_string(cells[1]) + " x " +
    std::to_string(cells[2]);
}

} // namespace vfm
