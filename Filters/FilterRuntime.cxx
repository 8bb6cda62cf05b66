#include "FilterRuntime.h"

#include "EmptyOutput.h"
#include "FailedOutput.h"

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"
#include "vtkInformationVector.h"

namespace vfm
{
void FilterRuntime::Progress(double fraction, const char* stage)
{
  this->Owner->SetProgressText(stage);
  this->Owner->UpdateProgress(fraction);
  if (this->Owner->GetAbortExecute() && this->Group().Count() == 1)
  {
    throw Aborted();
  }
}

void FilterRuntime::Report(
  vtkAlgorithm* owner, vtkInformationVector* outputs, const std::function<void()>& work)
{
  owner->SetAbortExecute(0); // may be left from an earlier run
  try
  {
    work();
  }
  catch (const Aborted&)
  {
    for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
    {
      EmptyOutput(outputs->GetInformationObject(port));
    }
  }
  catch (const InputError& error)
  {
    Fail(owner, outputs, error.what());
  }
}

} // namespace vfm
