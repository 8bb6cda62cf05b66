#include "vtkPVMaterialsInformation.h"

#include "vtkAlgorithm.h"
#include "vtkClientServerStream.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkObjectFactory.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"

vtkStandardNewMacro(vtkPVMaterialsInformation);

vtkPVMaterialsInformation::vtkPVMaterialsInformation()
{
  this->SetRootOnly(1); // names are equal on all ranks
}

bool vtkPVMaterialsInformation::CopyFromFieldData(vtkFieldData* field)
{
  auto* ids = vtkDataArray::SafeDownCast(field->GetAbstractArray("MaterialIds"));
  auto* names = vtkStringArray::SafeDownCast(field->GetAbstractArray("MaterialNames"));
  if (!ids || !names || ids->GetNumberOfValues() != names->GetNumberOfValues())
  {
    return false;
  }
  for (vtkIdType m = 0; m < names->GetNumberOfValues(); ++m)
  {
    this->Names[static_cast<int>(ids->GetComponent(m, 0))] = names->GetValue(m);
  }
  return true;
}

void vtkPVMaterialsInformation::CopyFromObject(vtkObject* object)
{
  this->Names.clear();
  auto* algorithm = vtkAlgorithm::SafeDownCast(object);
  for (int port = 0; algorithm && port < algorithm->GetNumberOfOutputPorts(); ++port)
  {
    vtkDataObject* output = algorithm->GetOutputDataObject(port);
    if (!output || this->CopyFromFieldData(output->GetFieldData()))
    {
      continue;
    }
    if (auto* blocks = vtkCompositeDataSet::SafeDownCast(output))
    {
      auto leaf = vtkSmartPointer<vtkCompositeDataIterator>::Take(blocks->NewIterator());
      for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
      {
        this->CopyFromFieldData(leaf->GetCurrentDataObject()->GetFieldData());
      }
    }
  }
}

void vtkPVMaterialsInformation::CopyToStream(vtkClientServerStream* stream)
{
  stream->Reset();
  *stream << vtkClientServerStream::Reply << static_cast<int>(this->Names.size());
  for (const auto& [id, name] : this->Names)
  {
    *stream << id << name.c_str();
  }
  *stream << vtkClientServerStream::End;
}

void vtkPVMaterialsInformation::CopyFromStream(const vtkClientServerStream* stream)
{
  this->Names.clear();
  int count = 0;
  stream->GetArgument(0, 0, &count);
  for (int m = 0; m < count; ++m)
  {
    int id = 0;
    const char* name = nullptr;
    if (stream->GetArgument(0, 1 + 2 * m, &id) && stream->GetArgument(0, 2 + 2 * m, &name) && name)
    {
      this->Names[id] = name;
    }
  }
}
