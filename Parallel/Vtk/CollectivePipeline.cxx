#include "CollectivePipeline.h"

#include "ControllerRanks.h"
#include "FailedOutput.h"
#include "Ranks/WorkTogether.h"

#include "vtkAlgorithm.h"
#include "vtkCommand.h"
#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"

#include <cstdio>
#include <cstring>

namespace vfm
{
namespace
{

/// Returns the result of work(), or false if it throws.
template <class Work>
bool Try(const Work& work) noexcept
{
  try
  {
    return work();
  }
  catch (...)
  {
    return false;
  }
}

constexpr const char* Failed = "The input could not be made";

[[noreturn]] void ThrowInputError(const Ranks& ranks)
{
  char text[64];
  std::snprintf(text, sizeof(text), "%s on rank %d.", Failed, ranks.Rank());
  throw InputError(ranks.Count() > 1 ? text : "The input could not be made.");
}

/// Throws an error with the message of a failed input.
[[noreturn]] void ThrowInputError(const char* why)
{
  const bool isInputOfInput = std::strncmp(why, Failed, std::strlen(Failed)) == 0;
  char text[Failure::LongestText];
  std::snprintf(text, sizeof(text), "%s: %s", Failed, why);
  throw InputError(isInputOfInput ? why : text);
}

bool HasAll(vtkInformationVector* outputs)
{
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    if (!vtkDataObject::GetData(outputs, port))
    {
      return false;
    }
  }
  return true;
}

} // namespace

vtkStandardNewMacro(CollectivePipeline);

CollectivePipeline* CollectivePipeline::Make(const GetController& getController)
{
  CollectivePipeline* pipeline = CollectivePipeline::New();
  pipeline->Controller = getController;
  return pipeline;
}

vtkTypeBool CollectivePipeline::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inInfo, vtkInformationVector* outInfo)
{
  return request->Has(REQUEST_DATA()) ? this->ProcessDataRequest(request, inInfo, outInfo)
                                      : this->ProcessEarlyRequest(request, inInfo, outInfo);
}

/// Processes a request before REQUEST_DATA. Always returns 1, so that VTK goes on to REQUEST_DATA.
/// After a failure the request is repeated next time.
vtkTypeBool CollectivePipeline::ProcessEarlyRequest(
  vtkInformation* request, vtkInformationVector** inInfo, vtkInformationVector* outInfo)
{
  const auto process = [&] { return this->Superclass::ProcessRequest(request, inInfo, outInfo); };
  if (!Try(process))
  {
    this->HasInputFailed = true;
  }
  if (this->HasInputFailed)
  {
    this->DataObjectTime = vtkTimeStamp();
    this->InformationTime = vtkTimeStamp();
    this->LastPropogateUpdateExtentShortCircuited = 0;
  }
  return 1;
}

vtkTypeBool CollectivePipeline::ProcessDataRequest(
  vtkInformation* request, vtkInformationVector** inInfo, vtkInformationVector* outInfo)
{
  this->IsDataNeeded = this->HasJoined = false;
  const bool worked =
    Try([&] { return this->Superclass::ProcessRequest(request, inInfo, outInfo); });
  if (!this->IsDataNeeded || this->HasJoined)
  {
    return worked;
  }
  this->HasInputFailed = true;
  // ExecuteData calls CallAlgorithm and marks the outputs before and after it.
  Try([&] { return this->vtkDemandDrivenPipeline::ExecuteData(request, inInfo, outInfo); });
  if (!this->HasJoined)
  {
    this->CallAlgorithm(request, RequestDownstream, inInfo, outInfo);
  }
  this->DataTime.Modified();
  this->InformationTime.Modified();
  this->DataObjectTime.Modified();
  this->HasInputFailed = false;
  return HasAll(outInfo);
}

int CollectivePipeline::ForwardUpstream(vtkInformation* request)
{
  if (request->Has(REQUEST_DATA_OBJECT())) // the first request of an update
  {
    this->HasInputFailed = false;
  }
  const bool isData = request->Has(REQUEST_DATA());
  this->IsDataNeeded = this->IsDataNeeded || isData;
  if (!(isData && this->HasInputFailed) &&
    !Try([&] { return this->Superclass::ForwardUpstream(request); }))
  {
    this->HasInputFailed = true;
  }
  return !(isData && this->HasInputFailed);
}

/// Throws if the input is missing or failed. Algorithms without outputs (writers) report failed
/// inputs themselves, together with their file.
void CollectivePipeline::CheckInput(vtkInformationVector** inInfo, const Ranks& ranks)
{
  if (this->HasInputFailed)
  {
    ThrowInputError(ranks);
  }
  const int ports = this->GetNumberOfOutputPorts() > 0 ? this->GetNumberOfInputPorts() : 0;
  for (int port = 0; port < ports; ++port)
  {
    for (int i = 0; i < inInfo[port]->GetNumberOfInformationObjects(); ++i)
    {
      const char* why = FindFailure(vtkDataObject::GetData(inInfo[port], i));
      if (*why)
      {
        ThrowInputError(why);
      }
    }
  }
}

int CollectivePipeline::CallAlgorithm(vtkInformation* request, int direction,
  vtkInformationVector** inInfo, vtkInformationVector* outInfo)
{
  const auto call = [&]
  { return this->Superclass::CallAlgorithm(request, direction, inInfo, outInfo); };
  if (!request->Has(REQUEST_DATA()))
  {
    return call();
  }
  this->HasJoined = true;
  bool hasInput = false, hasReturned = false;
  int result = 1;
  try
  {
    ControllerRanks ranks(this->Controller());
    const auto work = [&]
    {
      this->CheckInput(inInfo, ranks);
      hasInput = true;
      result = call();
      hasReturned = true; // the algorithm has reported its errors
    };
    WorkTogether(ranks, work, Ranks::Frame::Filter);
  }
  catch (const InputError& error)
  {
    MarkFailed(outInfo, error.what());
    if (!hasReturned)
    {
      // The source of the input has reported the error. For a writer that may be long ago.
      this->Report(error.what(), hasInput || outInfo->GetNumberOfInformationObjects() == 0);
    }
  }
  return result;
}

/// Reports an error of the algorithm.
/// @param isShown  false: only observers of the algorithm receive the error
void CollectivePipeline::Report(const char* text, bool isShown)
{
  if (isShown || this->Algorithm->HasObserver(vtkCommand::ErrorEvent))
  {
    vtkErrorWithObjectMacro(this->Algorithm, << text);
  }
}

} // namespace vfm
