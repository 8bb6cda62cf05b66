/**
 * CollectivePipeline: the executive of an algorithm whose RequestData is
 * collective over a controller.
 */
#pragma once

#include "VtkVersions.h"

#include <functional>

class vtkMultiProcessController;

namespace vfm
{

class Ranks;

/// Executive that handles errors on all ranks (WorkTogether). VTK does not run an algorithm whose
/// input failed, and ranks whose input did not fail would wait for it in RequestData. This
/// executive joins the other ranks with an error. Failures of requests before REQUEST_DATA are
/// stored until then, because only then all ranks are certain to take part.
///
/// After a failure the outputs are up to date on all ranks, empty, and hold the message
/// (FailedOutput). The same happens on a single rank, and if the input is itself such an output.
/// The error is shown unless another one was.
class CollectivePipeline : public CompositePipeline
{
public:
  static CollectivePipeline* New();
  vtkTypeMacro(CollectivePipeline, CompositePipeline);

  /// Function that returns the controller of the algorithm, or null for a single rank.
  using GetController = std::function<vtkMultiProcessController*()>;
  /// Returns an executive for CreateDefaultExecutive; the caller owns it.
  /// @param getController  called in each REQUEST_DATA
  static CollectivePipeline* Make(const GetController& getController);

  vtkTypeBool ProcessRequest(
    vtkInformation* request, vtkInformationVector** inInfo, vtkInformationVector* outInfo) override;
  int CallAlgorithm(vtkInformation* request, int direction, vtkInformationVector** inInfo,
    vtkInformationVector* outInfo) override;

protected:
  int ForwardUpstream(vtkInformation* request) override;
  using Superclass::ForwardUpstream; // overload for one connection

private:
  vtkTypeBool ProcessEarlyRequest(
    vtkInformation* request, vtkInformationVector** inInfo, vtkInformationVector* outInfo);
  vtkTypeBool ProcessDataRequest(
    vtkInformation* request, vtkInformationVector** inInfo, vtkInformationVector* outInfo);
  void CheckInput(vtkInformationVector** inInfo, const Ranks& ranks);
  void Report(const char* text, bool isShown);

  GetController Controller = [] { return nullptr; };
  bool HasInputFailed = false; // whether a request since REQUEST_DATA_OBJECT failed
  bool IsDataNeeded = false;   // whether the current request needs data
  bool HasJoined = false;      // whether this rank joined the others in the current request
};

} // namespace vfm
