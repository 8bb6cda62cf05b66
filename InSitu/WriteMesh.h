/**
 * WriteMesh: the mesh of all ranks as files.
 */
#pragma once

#include <string>
#include <vector>

class vtkMultiProcessController;
class vtkUnstructuredGrid;

namespace vfm
{

enum class OutputFiles
{
  AsUsual, ///< of the format
  Single   ///< one of the whole mesh, which rank 0 gathers
};

/// Such as ".vtu".
std::vector<std::string> GetOutputSuffixes();
/// Throws ProgramError (WrongArguments) when files of that name are not written, or not as a single one.
void CheckOutputSuffix(const std::string& path, OutputFiles files = OutputFiles::AsUsual);
/// Throws ProgramError (UnwritableOutput) when the folder is not there or cannot be written to.
void CheckOutputFolder(const std::string& path);

/// Collective: .vtu, one file of the whole mesh, which rank 0 gathers; .pvtu with one piece a rank; Exodus, one file a
/// rank (path.N.RANK when there are several) unless a single one is asked for; .inp of Abaqus, one file. Throws ProgramError (UnwritableOutput).
void WriteMesh(vtkUnstructuredGrid* mesh, const std::string& path,
  vtkMultiProcessController* controller, OutputFiles files = OutputFiles::AsUsual);

} // namespace vfm
