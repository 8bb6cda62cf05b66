/**
 * CollectivePipeline: the executive of an algorithm whose RequestData needs all processes of a controller.
 *
 * VTK does not run an algorithm whose input failed; other processes, where the input did not fail, would wait for it in
 * RequestData. Here it joins them (WorkTogether) with an error. What fails before, in the requests that come ahead of the data, is kept until the
 * data are asked for, since only then others are sure to come. Afterwards the outputs are as up to date as on the others, empty,
 * and say why (FailedOutput); so they are on a process that is alone, and where the input is itself such an output. The error is shown
 * where no other was.
 */
#pragma once

#include "VtkVersions.h"

#include <functional>

class vtkMultiProcessController;

namespace vfm
{

class Ranks;

class CollectivePipeline : public CompositePipeline
{
public:
  static CollectivePipeline* New();
  vtkTypeMacro(CollectivePipeline, CompositePipeline);

  /// getController: of the algorithm, when it is needed; may return null, then there is one process.
  using GetController = std::function<vtkMultiProcessController*()>;
  /// For CreateDefaultExecutive.
  static CollectivePipeline* Make(const GetController& getController);

  vtkTypeBool ProcessRequest(
    vtkInformation* request, vtkInformationVector** inInfo, vtkInformationVector* outInfo) override;
  int CallAlgorithm(vtkInformation* request, int direction, vtkInformationVector** inInfo,
    vtkInformationVector* outInfo) override;

protected:
  int ForwardUpstream(vtkInformation* request) override;
  using Superclass::ForwardUpstream; // of one connection

private:
  vtkTypeBool ProcessEarlyRequest(
    vtkInformation* request, vtkInformationVector** inInfo, vtkInformationVector* outInfo);
  vtkTypeBool ProcessDataRequest(
    vtkInformation* request, vtkInformationVector** inInfo, vtkInformationVector* outInfo);
  void CheckInput(vtkInformationVector** inInfo, const Ranks& ranks);
  void Report(const char* text, bool isShown);

  GetController Controller = [] { return nullptr; };
  bool HasInputFailed = false; // since data were asked for
  bool IsDataNeeded = false;   // in the present request
  bool HasJoined = false;      // the others, in the present request
};

} // namespace vfm
