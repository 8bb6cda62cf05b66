/**
 * HostGrid: what a host code (a simulation) holds on one rank, in plain terms. Knows neither VTK nor MPI nor Catalyst: the C
 * interface and every in-situ adaptor start from it.
 *
 * Cells are numbered (i,j,k) over the whole grid, from 0. The values of a box are those of its cells alone, x fastest:
 * value (i,j,k) of component c is values[((k * ny + j) * nx + i) * components + c], i, j, k from the box's lower corner.
 *
 * A box may be of a finer level (AMR): cells of level L are those of level 0 halved L times along each axis, and are numbered
 * over the whole grid as if it had no others. Boxes of coarser levels may lie below those of finer ones or not; what they hold there is
 * ignored by the mesher.
 */
#pragma once

#include "Base/IndexBox.h"

#include <string>
#include <type_traits>
#include <vector>

namespace vfm
{

/// The numbers are those of VTK.
enum class HostType
{
  UnsignedChar = 3,
  Int = 6,
  Float = 10,
  Double = 11
};

/// Values of the host, one tuple of components a cell. They must stay where they are as long as data made of them lives,
/// and are never written to. An unsigned char array named vtkGhostType marks cells that are copies of another box's.
struct HostArray
{
  std::string Name;
  int Components = 1;
  HostType Type = HostType::Double;
  const void* Values = nullptr;
};

struct HostBox
{
  IndexBox Cells; ///< of its level
  std::vector<HostArray> Arrays;
  int Level = 0; ///< 0: the coarsest
};

constexpr int MaximumHostLevels = 30; ///< above level 0

/// A grid, of which this rank holds some boxes, or none. Node (i,j,k) of level L is at Origin + (i,j,k) * Spacing / 2^L.
struct HostGrid
{
  Vector3 Origin{ { 0, 0, 0 } };  ///< of the whole grid, same on all ranks
  Vector3 Spacing{ { 1, 1, 1 } }; ///< edges of a cell of level 0
  Index3 Cells{ { 0, 0, 0 } };    ///< of level 0 in the whole grid, along x, y, z
  std::vector<HostBox> Boxes;
};

/// An array of the host's values: double, float, int or unsigned char. name: not empty; values: one tuple of components for every
/// cell of its box.
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

/// Throws InputError that names what is wrong: spacing that is not positive, numbers that are not finite, no cells,
/// more cells along an axis than an int counts; a box that is empty or leaves the grid, a level out of range; an array
/// without name, values or components, or twice in a box. Boxes that overlap or leave gaps are found by the mesher.
void CheckHostGrid(const HostGrid& grid);

/// Edges of the cells of a level.
Vector3 SpacingOf(const HostGrid& grid, int level);

} // namespace vfm
