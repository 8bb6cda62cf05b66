#include "vtkVolumeFractionSolverWriter.h"

#include "Meshes/WriteMesh.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkVolumeFractionSolverWriter);

void vtkVolumeFractionSolverWriter::WriteMesh(
  const vfm::MeshData& mesh, const std::string& path, vfm::Ranks& ranks)
{
  vfm::WriteMesh(mesh, path, ranks);
}
