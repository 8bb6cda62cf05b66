/**
 * RegularTets: tets whose corners are all at nodes and centres of cells. They are the tets between
 * the centres of two cells and an edge of their common face, and tets in one cell with a corner at
 * its centre. Most tets by Lattice and Cells are regular, because points move only near interfaces.
 * Their parts in cells have a closed form.
 */
#pragma once

#include "Base/Runtime.h"
#include "Mesh/Mesh.h"

#include <array>
#include <cstdint>

namespace vfm
{

/// Part of an element in a cell.
struct OverlapPart
{
  Index Cell = 0;      ///< index of the cell in grid.Local() (IndexInBox)
  double Volume = 0.0; ///< > 0, length units cubed
  Vector3 Centroid{};  ///< point in the cell
};

/// Cuts the regular tets of a mesh. Thread safe once made. Mesh and grid must outlive it.
class RegularTets
{
public:
  RegularTets(const Mesh& mesh, const CartesianGrid& grid, Runtime& runtime);

  /// Cuts an element if it is a regular tet.
  /// @param[out] parts  parts, ascending by cell
  /// @return number of parts, 0 if the element is not a regular tet
  int Cut(Index element, std::array<OverlapPart, 2>& parts) const
  {
    return this->Places.empty() ? 0 : this->CutTet(element, parts);
  }

private:
  int CutTet(Index element, std::array<OverlapPart, 2>& parts) const;
  int CutInCell(const Index* points, int centre, std::array<OverlapPart, 2>& parts) const;
  int CutInTwo(
    const Index* points, std::array<int, 4> order, std::array<OverlapPart, 2>& parts) const;
  OverlapPart HalfOf(
    std::int64_t place, const Vector3& centre, const Vector3& a, const Vector3& b, int axis) const;
  Index CellOf(std::int64_t centre) const;

  const Mesh& TheMesh;
  const CartesianGrid& Grid;
  // Place of each point: twice its coordinates in cells of the local box, as three fields of bits.
  // They are even at nodes and odd at centres; -1 elsewhere. Empty for hexes.
  std::vector<std::int64_t> Places;
};

} // namespace vfm
