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

/// Whether it worked; an exception is a failure.
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

/// why: what the input says.
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

/// Never fails, so that the data are asked for; does the request again next time.
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
  // CallAlgorithm, and what marks the outputs before and after it
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
  if (request->Has(REQUEST_DATA_OBJECT())) // the first of all requests
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

/// Throws when there is no input, or none that was made; an algorithm without outputs, a writer, tells the latter with its file.
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
      hasReturned = true; // and has told what failed
    };
    WorkTogether(ranks, work, Ranks::Frame::Filter);
  }
  catch (const InputError& error)
  {
    MarkFailed(outInfo, error.what());
    if (!hasReturned)
    {
      // what made the input has told why, long ago when it is a writer that asks
      this->Report(error.what(), hasInput || outInfo->GetNumberOfInformationObjects() == 0);
    }
  }
  return result;
}

/// isShown: else only those who watch the algorithm are told.
void CollectivePipeline::Report(const char* text, bool isShown)
{
  if (isShown || this->Algorithm->HasObserver(vtkCommand::ErrorEvent))
  {
    vtkErrorWithObjectMacro(this->Algorithm, << text);
  }
}

} // namespace vfm
