#include "FailedOutput.h"

#include "EmptyOutput.h"
#include "Ranks/PrintableText.h"

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkStringArray.h"

#include <exception>

namespace vfm
{
namespace
{

constexpr const char* ArrayName = "MeshError";

} // namespace

void MarkFailed(vtkInformationVector* outputs, const char* text) noexcept
{
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    try
    {
      EmptyOutput(outputs->GetInformationObject(port));
      if (vtkDataObject* output = vtkDataObject::GetData(outputs, port))
      {
        vtkNew<vtkStringArray> array;
        array->SetName(ArrayName);
        array->InsertNextValue(text);
        array->GetInformation()->Set(vtkAbstractArray::GUI_HIDE(), 1);
        output->GetFieldData()->AddArray(array);
      }
    }
    catch (const std::exception&) // not enough memory: the output is at least empty
    {
    }
  }
}

void Fail(vtkAlgorithm* algorithm, vtkInformationVector* outputs, const char* text)
{
  MarkFailed(outputs, text);
  vtkErrorWithObjectMacro(algorithm, << MakePrintable(text));
}

const char* FindFailure(vtkDataObject* data) noexcept
{
  vtkFieldData* field = data ? data->GetFieldData() : nullptr;
  auto array = field ? vtkStringArray::SafeDownCast(field->GetAbstractArray(ArrayName)) : nullptr;
  return array && array->GetNumberOfValues() > 0 ? array->GetValue(0).c_str() : "";
}

} // namespace vfm
