/**
 * EmptyOutput: empty outputs that the pipeline and downstream filters accept.
 */
#pragma once

class vtkInformation;
class vtkUnstructuredGrid;

namespace vfm
{

/// Removes all elements of a mesh, but keeps allocated memory for one element without corners,
/// because vtkMeshQuality reads the first element even if there is none.
void SetNoElements(vtkUnstructuredGrid* mesh);

/// Empties the output of a port. A mesh is emptied by SetNoElements. An image gets the requested
/// extent, without values: VTK would repeat the request for any other extent forever.
void EmptyOutput(vtkInformation* port);

} // namespace vfm
