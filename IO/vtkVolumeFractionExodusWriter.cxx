#include "vtkVolumeFractionExodusWriter.h"

#include "WriteExodus.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkVolumeFractionExodusWriter);

void vtkVolumeFractionExodusWriter::WriteMesh(
  vtkUnstructuredGrid* mesh, const std::string& path, vfm::Ranks& ranks)
{
  vfm::WriteExodus(
    mesh, path, ranks, this->SingleFile ? vfm::ExodusParts::One : vfm::ExodusParts::OneARank);
}

void vtkVolumeFractionExodusWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SingleFile: " << this->SingleFile << "\n";
}
