/**
 * MeshFaces: the faces of a mesh at which a value of its elements changes, across the ranks.
 */
#pragma once

#include "MatchFaces.h"

#include "vtkType.h"

#include <string>

class vtkUnstructuredGrid;

namespace vfm
{

struct MeshFace
{
  vtkIdType Cell;
  int Face;            ///< as vtkHexahedron and vtkTetra number them
  int Corners;         ///< 4 or 3
  vtkIdType Points[4]; ///< of the mesh of this rank, seen from outside counterclockwise
  int Behind;          ///< the value on the other side, or NothingBehind
};

/// Collective: the faces of this rank's elements behind which there is another value, or nothing; by cell and face.
/// mesh: of hexahedra or tetrahedra, with global point ids; its cell array of that name holds integers >= 0. Its point array
/// GeometryDimension, when it is there, tells which faces may be such: those without points inside (3).
/// Throws InputError, on all ranks alike, when an array is missing, cells are of other types or a face belongs to more than two elements.
std::vector<MeshFace> FindMeshFaces(
  vtkUnstructuredGrid* mesh, const std::string& name, Ranks& ranks);

} // namespace vfm
