#include "vtkVolumeFractionExodusWriter.h"

#include "Meshes/Exodus/WriteExodus.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkVolumeFractionExodusWriter);

void vtkVolumeFractionExodusWriter::WriteMesh(
  const vfm::MeshData& mesh, const std::string& path, vfm::Ranks& ranks)
{
  vfm::WriteExodus(
    mesh, path, ranks, this->SingleFile ? vfm::ExodusParts::One : vfm::ExodusParts::OnePerRank);
}

void vtkVolumeFractionExodusWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SingleFile: " << this->SingleFile << "\n";
}
