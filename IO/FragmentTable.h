/**
 * FragmentTable: what each fragment of a mesh is, as a table.
 */
#pragma once

#include "Ranks/Ranks.h"

#include <string>
#include <vector>

class vtkTable;
class vtkUnstructuredGrid;

namespace vfm
{

/// Collective: fills the table of rank 0, a row a fragment in the order of their ids, with the columns FragmentId, MaterialId, Material
/// (name), Elements, FractionVolume (of its cells' fractions, where the field data has it), MeshVolume, CentroidX/Y/Z (of the volume), MinX, MaxX, MinY,
/// MaxY, MinZ, MaxZ, Mass (with densities) and Neighbours (ids of the fragments that it touches, with blanks between). Other ranks'
/// tables stay empty. The same numbers for any number of ranks.
/// mesh: of Volume Fraction To Hex or To Tet. densities: names of cell arrays of mass per volume: none, one for all materials, or one
/// a material in the order of the field data MaterialIds. Throws InputError, on all ranks alike, when arrays are missing or their number is another.
void MakeFragmentTable(vtkUnstructuredGrid* mesh, const std::vector<std::string>& densities,
  Ranks& ranks, vtkTable* table);

} // namespace vfm
