/**
 * EmptyOutput: outputs without anything that neither the pipeline nor the filters behind stumble over.
 */
#pragma once

class vtkInformation;
class vtkUnstructuredGrid;

namespace vfm
{

/// Gives a mesh no elements, but beyond their end the memory of one without corners: vtkMeshQuality looks at the first element
/// whether there is any or not.
void SetNoElements(vtkUnstructuredGrid* mesh);

/// Initializes the output of a port; a mesh as above. An image gets the extent that is asked for, without values: for another VTK
/// would ask again and again.
void EmptyOutput(vtkInformation* port);

} // namespace vfm
