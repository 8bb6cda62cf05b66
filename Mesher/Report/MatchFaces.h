/**
 * MatchFaces: finds the elements on the other side of faces, also on other ranks.
 */
#pragma once

#include "Elements/ElementFaces.h"
#include "Ranks/Ranks.h"
#include "Report/MeshData.h"

namespace vfm
{

/// Returns the points of a side, counterclockwise seen from outside of the element. The last point
/// of a triangle, and the last two of an edge, are -1.
FaceIds PointsOfSide(const MeshData& mesh, const ElementSide& side);
/// Returns the values of these points.
/// @param ofCorners  a value for each corner of an element of the mesh
FaceIds ValuesOfSide(const MeshData& mesh, const Index* ofCorners, int side);
/// Returns the points of a side in ascending order. The first point of a triangle is -1.
FaceIds SortedPointsOfSide(const MeshData& mesh, const ElementSide& side);

/// Returns ids of the points of a face, sorted.
/// @param ids id of each point, such as its global id; the -1 of a triangle stays
FaceIds SortedIds(const FaceIds& points, const Index* ids);

/// Returns the element of this rank behind each side of the elements of a mesh, element by element,
/// or NothingBehind.
/// @throws InputError if a face belongs to more than two elements
std::vector<Index> MatchSides(const MeshData& mesh);

/// Finds the values of the element behind each face.
/// @param ids sorted global ids of the points of each face
/// @param values `width` values >= 0 of the element of each face, such as its material or number
/// @return `width` values per face of the element on the other side, on any rank; NothingBehind if
///   there is none
/// @throws InputError if a face belongs to more than two elements of one rank, or to elements of
/// three ranks; on all ranks
/// @pre Collective
std::vector<Index> MatchFaces(const std::vector<FaceIds>& ids, const std::vector<Index>& values,
  Ranks& ranks, std::size_t width = 1);

} // namespace vfm
