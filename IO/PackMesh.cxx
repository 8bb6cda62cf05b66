#include "PackMesh.h"

#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLUnstructuredGridReader.h"
#include "vtkXMLUnstructuredGridWriter.h"

#include <string>

namespace vfm
{

Bytes PackGrid(vtkUnstructuredGrid* mesh)
{
  vtkNew<vtkUnstructuredGrid> timeless; // the writer would make field data of the time
  timeless->ShallowCopy(mesh);
  timeless->GetInformation()->Remove(vtkDataObject::DATA_TIME_STEP());
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetInputData(timeless);
  writer->SetWriteToOutputString(true);
  writer->SetDataModeToBinary();
  writer->SetCompressorTypeToNone();
  writer->SetHeaderTypeToUInt64();
  writer->Write();
  const std::string text = writer->GetOutputString();
  return Bytes(text.begin(), text.end());
}

vtkSmartPointer<vtkUnstructuredGrid> UnpackGrid(const Bytes& bytes)
{
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetReadFromInputString(1);
  reader->SetInputString(std::string(bytes.begin(), bytes.end()));
  reader->Update();
  return reader->GetOutput();
}

} // namespace vfm
