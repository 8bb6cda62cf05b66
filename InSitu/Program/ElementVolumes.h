/**
 * ElementVolumes: exact volumes of hexahedra (trilinear) and tetrahedra.
 */
#pragma once

#include <vector>

class vtkUnstructuredGrid;

namespace vfm
{

/// Of each element, in length units cubed.
std::vector<double> FindElementVolumes(vtkUnstructuredGrid* mesh);

} // namespace vfm
