/**
 * HostGrid: grid and fields of a host (a simulation) on one rank, without VTK, MPI or Catalyst. The
 * C interface and the Catalyst adaptors use it.
 *
 * Cells are numbered (i,j,k) over the whole grid, from 0. A box has values of its own cells only, x
 * fastest: values[((k * ny + j) * nx + i) * components + c] is component c of cell (i,j,k), counted
 * from the lower corner of the box.
 *
 * A box may be on a finer level (AMR). Cells of level L are cells of level 0 that are halved L
 * times along each axis. They are numbered as if the whole grid had level L. Boxes of coarser
 * levels below finer ones are optional; the mesher ignores their values there.
 */
#pragma once

#include "Base/IndexBox.h"

#include <string>
#include <type_traits>
#include <vector>

namespace vfm
{

/// Type of values, with the numbers of VTK (VTK_UNSIGNED_CHAR, ..).
enum class HostType
{
  UnsignedChar = 3,
  Int = 6,
  Float = 10,
  Double = 11
};

/// Values of the host, one tuple of components per cell. They are not copied and never written.
/// They must stay allocated as long as data made of them exist. An array of unsigned char named
/// vtkGhostType marks cells that are copies of cells of another box.
struct HostArray
{
  std::string Name;
  int Components = 1;
  HostType Type = HostType::Double;
  const void* Values = nullptr;
};

/// Box of cells with arrays.
struct HostBox
{
  IndexBox Cells; ///< cells, numbered on its level
  std::vector<HostArray> Arrays;
  int Level = 0; ///< 0 for the coarsest cells
};

constexpr int MaximumHostLevels = 30; ///< finest level

/// Grid of all ranks with the boxes of this rank, possibly none. Node (i,j,k) of level L is at
/// Origin + (i,j,k) * Spacing / 2^L.
struct HostGrid
{
  Vector3 Origin{ { 0, 0, 0 } };  ///< lower corner of the grid, equal on all ranks
  Vector3 Spacing{ { 1, 1, 1 } }; ///< edge lengths of a cell of level 0
  Index3 Cells{ { 0, 0, 0 } };    ///< numbers of level-0 cells along x, y, z
  std::vector<HostBox> Boxes;
};

/// Makes an array from values of type double, float, int or unsigned char.
/// @param name  name of the array, not empty
/// @param values  (cells of the box, components), row-major; not copied
template <class T>
HostArray MakeHostArray(const std::string& name, const T* values, int components = 1)
{
  constexpr bool isDouble = std::is_same_v<T, double>, isFloat = std::is_same_v<T, float>,
                 isInt = std::is_same_v<T, int>;
  static_assert(isDouble || isFloat || isInt || std::is_same_v<T, unsigned char>);
  return { name, components,
    isDouble    ? HostType::Double
      : isFloat ? HostType::Float
      : isInt   ? HostType::Int
                : HostType::UnsignedChar,
    values };
}

/// Checks the grid and the boxes of this rank. Not collective. Overlaps and gaps between boxes are
/// found by the mesher.
/// @throws InputError  if
///   - a spacing is not positive, a number not finite, or the grid has no cells
///   - the grid has more cells along an axis than int can count
///   - a box is empty or leaves the grid, or its level is out of range
///   - an array has no name, values or components, or a box has two arrays of one name
void CheckHostGrid(const HostGrid& grid);

/// Returns the edge lengths of cells of a level.
Vector3 SpacingOf(const HostGrid& grid, int level);

} // namespace vfm
