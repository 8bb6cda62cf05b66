#include "vtkVolumeFractionAbaqusWriter.h"

#include "WriteAbaqus.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkVolumeFractionAbaqusWriter);

void vtkVolumeFractionAbaqusWriter::WriteMesh(
  vtkUnstructuredGrid* mesh, const std::string& path, vfm::Ranks& ranks)
{
  vfm::WriteAbaqus(mesh, path, ranks);
}
