#include "CollectivePipeline.h"

#include "Base/WorkTogether.h"
#include "ControllerRanks.h"

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"

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

[[noreturn]] void ThrowInputError(int rank)
{
  char text[64];
  std::snprintf(text, sizeof(text), "The input could not be made on rank %d.", rank);
  throw InputError(text);
}

} // namespace

vtkStandardNewMacro(CollectivePipeline);

CollectivePipeline* CollectivePipeline::Make(const GetController& getController)
{
  CollectivePipeline* pipeline = CollectivePipeline::New();
  pipeline->Controller = getController;
  return pipeline;
}

bool CollectivePipeline::IsAlone() const
{
  vtkMultiProcessController* controller = this->Controller ? this->Controller() : nullptr;
  return !controller || controller->GetNumberOfProcesses() == 1;
}

vtkTypeBool CollectivePipeline::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inInfo, vtkInformationVector* outInfo)
{
  if (this->IsAlone())
  {
    return this->Superclass::ProcessRequest(request, inInfo, outInfo);
  }
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
  bool worked = Try([&] { return this->Superclass::ProcessRequest(request, inInfo, outInfo); });
  if (this->IsDataNeeded && !this->HasJoined)
  {
    this->HasInputFailed = true;
    worked = false;
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
  }
  return worked;
}

int CollectivePipeline::ForwardUpstream(vtkInformation* request)
{
  if (this->IsAlone())
  {
    return this->Superclass::ForwardUpstream(request);
  }
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

int CollectivePipeline::CallAlgorithm(vtkInformation* request, int direction,
  vtkInformationVector** inInfo, vtkInformationVector* outInfo)
{
  const auto call = [&]
  { return this->Superclass::CallAlgorithm(request, direction, inInfo, outInfo); };
  if (!request->Has(REQUEST_DATA()) || this->IsAlone())
  {
    return call();
  }
  this->HasJoined = true;
  int result = 1; // 0: the algorithm has told why
  try
  {
    ControllerRanks ranks(this->Controller());
    const auto work = [&]
    {
      if (this->HasInputFailed)
      {
        ThrowInputError(ranks.Rank());
      }
      result = call();
    };
    WorkTogether(ranks, work, Ranks::Frame::Filter);
    return result;
  }
  catch (const InputError& error)
  {
    for (int port = 0; port < outInfo->GetNumberOfInformationObjects(); ++port)
    {
      if (vtkDataObject* output = vtkDataObject::GetData(outInfo, port))
      {
        output->Initialize();
      }
    }
    if (result)
    {
      vtkErrorWithObjectMacro(this->Algorithm, << error.what());
    }
    return 0;
  }
}

} // namespace vfm
