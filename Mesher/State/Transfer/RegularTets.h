/**
 * RegularTets: tets whose corners are all at nodes and centres of cells. They are the tets between
 * the centres of two cells and an edge of their common face, and the tets between the centre of a
 * cell and half of a face. Most tets by Lattice and Cells are regular, because points move only
 * near interfaces. A cell has 48 possible parts of such tets, which are known in closed form.
 */
#pragma once

#include "Base/Runtime.h"
#include "Elements/Mesh.h"

#include <array>
#include <cstdint>

namespace vfm
{

/// Part of a regular tet in a cell.
struct RegularPart
{
  Index Cell = -1; ///< CartesianGrid::Linear
  int Kind = 0;    ///< position of the part in its cell: 0 to RegularKinds - 1
};

constexpr int RegularKinds = 48;

/// Geometry of a kind of part. All numbers are integers, so sums of parts do not depend on their
/// order.
struct RegularShape
{
  int Volume = 0;                ///< in 24ths of the cell
  std::array<int, 3> Centroid{}; ///< relative to the centre of the cell, in eighths of its widths
};

constexpr int KindsInTwo = 24;

/// Returns the kind of the part between the centre of a cell, an edge of a face, and the projection
/// of the centre onto the face.
/// @param side  1 if the face is on the upper side of its axis
/// @param other  axis normal to the edge in the face
/// @param otherSide  1 if the edge is on the upper side of this axis
constexpr int KindInTwo(int axis, int side, int other, int otherSide)
{
  return 8 * axis + 4 * side + 2 * (other != (axis + 1) % 3) + otherSide;
}

/// Returns the kind of the part between the centre of a cell and half of a face.
/// @param missing  corner of the face that the half lacks
constexpr int KindInCell(int axis, int missing)
{
  return KindsInTwo + 8 * axis + missing;
}

constexpr std::array<RegularShape, RegularKinds> ListRegularShapes()
{
  std::array<RegularShape, RegularKinds> shapes{};
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int bits = 0; bits < 8; ++bits)
    {
      const int other = (axis + 1 + (bits >> 1 & 1)) % 3, side = bits >> 2;
      RegularShape& half = shapes[KindInTwo(axis, side, other, bits & 1)];
      half.Volume = 1;
      half.Centroid[axis] = side ? 3 : -3;
      half.Centroid[other] = bits & 1 ? 2 : -2;
      RegularShape& inCell = shapes[KindInCell(axis, bits)];
      inCell.Volume = 2;
      for (int a = 0; a < 3; ++a)
      {
        const bool isUpper = bits >> a & 1;
        inCell.Centroid[a] = a == axis ? (isUpper ? 3 : -3) : (isUpper ? -1 : 1);
      }
    }
  }
  return shapes;
}

/// Geometry of each kind.
constexpr std::array<RegularShape, RegularKinds> RegularShapes = ListRegularShapes();

/// Finds the regular tets of a mesh. Thread safe once made. Mesh and grid must outlive it.
class RegularTets
{
public:
  RegularTets(const Mesh& mesh, const CartesianGrid& grid, Runtime& runtime);

  /// Finds the parts of an element if it is a regular tet.
  /// @param[out] parts  parts, ascending by cell
  /// @return number of parts, 0 if the element is not a regular tet
  int Find(Index element, std::array<RegularPart, 2>& parts) const
  {
    return this->Places.empty() ? 0 : this->FindInTet(element, parts);
  }
  /// Returns whether there can be regular tets.
  bool IsUsed() const { return !this->Places.empty(); }

private:
  int FindInTet(Index element, std::array<RegularPart, 2>& parts) const;
  int FindInCell(std::int64_t centre, const std::array<std::int64_t, 3>& nodes,
    std::array<RegularPart, 2>& parts) const;
  int FindInTwo(std::int64_t one, std::int64_t two, std::int64_t a, std::int64_t b,
    std::array<RegularPart, 2>& parts) const;
  Index CellOf(std::int64_t centre) const;

  const Mesh& TheMesh;
  const CartesianGrid& Grid;
  // Place of each point: twice its coordinates in cells of the local box, as three fields of bits.
  // They are even at nodes and odd at centres; -1 elsewhere. Empty for hexes.
  std::vector<std::int64_t> Places;
};

} // namespace vfm
