/**
 * VoxelRows: relates the rows of a voxel file, values along its fastest axis, to the cells of a
 * box. The cells of the box are stored x fastest, as in VTK.
 */
#pragma once

#include "VoxelFile.h"

namespace vfm
{

/// Position of the rows of a voxel file in a box of cells. A plane holds the rows at one index of
/// the slowest axis.
class VoxelRows
{
public:
  VoxelRows(const VoxelFile& file, const IndexBox& box) : Axes(file.Axes), Box(box)
  {
    const Index strides[3] = { 1, box.Size(0), box.Size(0) * box.Size(1) };
    for (int i = 0; i < 3; ++i)
    {
      this->Sizes[i] = file.Cells[file.Axes[i]];
      this->Strides[i] = strides[file.Axes[i]];
    }
  }

  Index RowsInPlane() const { return this->Sizes[1]; }
  Index Planes() const { return this->Sizes[0]; }
  /// Returns the number of values per row.
  Index Length() const { return this->Sizes[2]; }
  /// Tests whether the box overlaps a plane.
  bool HasPlane(Index plane) const { return this->Has(0, plane); }

  /// Part of a row inside the box: its values First to Last - 1 belong to the cells Cell,
  /// Cell + Stride, ... of the box.
  struct Part
  {
    Index First = 0, Last = 0, Cell = 0, Stride = 1;
  };
  /// Returns the part of a row inside the box; an empty one if they do not overlap.
  Part Find(Index plane, Index row) const
  {
    if (!this->Has(0, plane) || !this->Has(1, row))
    {
      return {};
    }
    return { this->Lower(2), this->Box.Upper[this->Axes[2]],
      (plane - this->Lower(0)) * this->Strides[0] + (row - this->Lower(1)) * this->Strides[1],
      this->Strides[2] };
  }

  /// Returns the cell (i, j, k) of a value of a row.
  Index3 Cell(Index plane, Index row, Index value) const
  {
    Index3 cell;
    cell[this->Axes[0]] = plane;
    cell[this->Axes[1]] = row;
    cell[this->Axes[2]] = value;
    return cell;
  }

private:
  Index Lower(int i) const { return this->Box.Lower[this->Axes[i]]; }
  bool Has(int i, Index index) const
  {
    return index >= this->Lower(i) && index < this->Box.Upper[this->Axes[i]];
  }

  std::array<int, 3> Axes;             // axes from the slowest to the fastest
  std::array<Index, 3> Sizes, Strides; // size of the file and stride in the box, in this order
  IndexBox Box;
};

} // namespace vfm
