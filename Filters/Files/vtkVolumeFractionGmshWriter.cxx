#include "vtkVolumeFractionGmshWriter.h"

#include "Meshes/Gmsh/WriteGmsh.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkVolumeFractionGmshWriter);

void vtkVolumeFractionGmshWriter::WriteMesh(
  const vfm::MeshData& mesh, const std::string& path, vfm::Ranks& ranks)
{
  constexpr vfm::GmshVersion versions[] = { vfm::GmshVersion::Automatic, vfm::GmshVersion::V2_2,
    vfm::GmshVersion::V4_1 };
  vfm::WriteGmsh(mesh, path, ranks, { versions[this->Version], this->Binary, this->Interfaces });
}

void vtkVolumeFractionGmshWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Version: " << this->Version << "\n";
  os << indent << "Binary: " << this->Binary << "\n";
  os << indent << "Interfaces: " << this->Interfaces << "\n";
}
