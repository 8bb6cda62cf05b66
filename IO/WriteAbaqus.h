/**
 * WriteAbaqus: a mesh as an input file of Abaqus and CalculiX, to be read on its own or by *INCLUDE.
 *
 * The file holds the mesh alone: *NODE (set NALL), *ELEMENT of type C3D8 or C3D4 with an element set a material, all of them in the
 * set EALL, *NSET a side of the domain, *SURFACE a side set (MeshSets.h), and *INITIAL CONDITIONS of a velocity of the nodes, a point
 * array of three components with that word in its name; no section, material or step. Nodes and elements
 * are numbered from 1 in the order of their global ids: solvers make tables as long as the greatest number.
 */
#pragma once

#include "Ranks/Ranks.h"

#include <string>

class vtkUnstructuredGrid;

namespace vfm
{

/// Collective: one file, by rank 0, which needs the memory of GatherMesh; its bytes do not depend on the number of ranks.
/// mesh: hexahedra or tetrahedra, not both, with the arrays of the filters. Throws InputError, on all ranks alike, when the
/// mesh is empty or lacks an array, or the file cannot be written; then there is none.
void WriteAbaqus(vtkUnstructuredGrid* mesh, const std::string& path, Ranks& ranks);

} // namespace vfm
