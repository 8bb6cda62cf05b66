/**
 * CellSides: finds the cell behind each side of the cells of a mesh, also on other ranks.
 *
 * Sides have numbers: (sides of a cell) * cell + side, with sides as in ElementFaces. In a mesh of
 * a plane they are edges (FlatData.h).
 */
#pragma once

#include "Ranks/Ranks.h"
#include "Report/Sets/MeshSets.h"

namespace vfm
{

/// A side with a cell of another rank behind it.
struct RemoteSide
{
  Index Side; ///< number of the side
  Index Cell; ///< position of the cell behind in the whole mesh
  int Rank;   ///< rank of the cell behind
};

/// Value of CellSides::Behind if the cell behind is on another rank.
constexpr Index RemoteBehind = -2;

struct CellSides
{
  /// Cell of this rank behind each side, RemoteBehind or NothingBehind.
  std::vector<Index> Behind;
  std::vector<RemoteSide> Remote; ///< ascending by Side
};

/// Returns the side with a number.
ElementSide SideOfNumber(const MeshData& mesh, Index number);

/// Returns the points of a side, counterclockwise seen from outside of its cell, from the lowest
/// one; in a periodic mesh from the one with the lowest partner. The last point of a triangle, and
/// the last two of an edge, are -1.
FaceIds PointsOfSide(const MeshData& mesh, Index number);
/// Returns the points of a side in ascending order. The first point of a triangle is -1.
FaceIds SortedPointsOfSide(const MeshData& mesh, Index number);

/// Finds the cells behind all sides.
/// @param mesh  part of this rank, with PointIds
/// @param positions  position of each cell in the whole mesh
/// @throws InputError  if a face belongs to more than two cells, on all ranks
/// @pre Collective
CellSides FindCellSides(const MeshData& mesh, const std::vector<Index>& positions, Ranks& ranks);

} // namespace vfm
