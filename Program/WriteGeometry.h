/**
 * WriteGeometry: the surfaces, curves and vertices of all ranks as a file.
 */
#pragma once

#include <string>

class vtkMultiProcessController;
class vtkVolumeFractionMeshAlgorithm;

namespace vfm
{

/// Throws InputError (WrongArguments) when the name is not one of a .vtm.
void CheckGeometrySuffix(const std::string& path);

/// Collective: a .vtm of three blocks, Surfaces, Curves and Vertices, which are the ports of the filter with their tables; one without cells
/// is left out. Rank 0 gathers and writes them, so that files are the same from any number of ranks. time: of the data, or null. Throws InputError
/// (UnwritableOutput).
void WriteGeometry(vtkVolumeFractionMeshAlgorithm& mesher, const double* time,
  const std::string& path, vtkMultiProcessController* controller);

} // namespace vfm
