/**
 * EmptyMesh: meshes without elements over which no filter of VTK stumbles.
 */
#pragma once

class vtkDataObject;
class vtkUnstructuredGrid;

namespace vfm
{

/// Gives a mesh no elements, but beyond their end the memory of one without corners: vtkMeshQuality looks at the first element
/// whether there is any or not.
void SetNoElements(vtkUnstructuredGrid* mesh);

/// Initializes data; a mesh as above.
void MakeEmpty(vtkDataObject* data);

} // namespace vfm
