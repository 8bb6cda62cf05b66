#include "vtkVolumeFractionFoamWriter.h"

#include "Meshes/OpenFoam/WriteFoam.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkVolumeFractionFoamWriter);

void vtkVolumeFractionFoamWriter::WriteMesh(
  const vfm::MeshData& mesh, const std::string& path, vfm::Ranks& ranks)
{
  vfm::WriteFoam(mesh, path, ranks, { this->SingleFile, this->Binary });
}

void vtkVolumeFractionFoamWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Binary: " << this->Binary << "\n";
  os << indent << "SingleFile: " << this->SingleFile << "\n";
}
