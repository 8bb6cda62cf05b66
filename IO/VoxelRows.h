/**
 * VoxelRows: the rows of a voxel file, values along its fastest axis, and the cells of a box that they fill.
 *
 * The cells of the box are stored as VTK does, x fastest.
 */
#pragma once

#include "VoxelFile.h"

namespace vfm
{

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

  /// In a plane, that is at one index of the slowest axis; planes in the file, and values in a row.
  Index RowsInPlane() const { return this->Sizes[1]; }
  Index Planes() const { return this->Sizes[0]; }
  Index Length() const { return this->Sizes[2]; }
  bool HasPlane(Index plane) const { return this->Has(0, plane); }

  /// The values First to Last, without it, of a row go to the cells Cell, Cell + Stride, ...
  struct Part
  {
    Index First = 0, Last = 0, Cell = 0, Stride = 1;
  };
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

  /// The cell (i, j, k) of a value of a row.
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

  std::array<int, 3> Axes; // slowest to fastest, as the next two
  std::array<Index, 3> Sizes, Strides;
  IndexBox Box;
};

} // namespace vfm
