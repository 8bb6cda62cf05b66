#include "vtkVolumeFractionAbaqusWriter.h"

#include "Meshes/Decks/WriteAbaqus.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkVolumeFractionAbaqusWriter);

void vtkVolumeFractionAbaqusWriter::WriteMesh(
  const vfm::MeshData& mesh, const std::string& path, vfm::Ranks& ranks)
{
  vfm::WriteAbaqus(mesh, path, ranks, { .IsReduced = this->ReducedIntegration });
}

void vtkVolumeFractionAbaqusWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ReducedIntegration: " << this->ReducedIntegration << "\n";
}
