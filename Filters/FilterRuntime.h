/**
 * FilterRuntime: progress and abort through a vtkAlgorithm, and the frame of RequestData around the Grid code.
 */
#pragma once

#include "Base/ThreadRuntime.h"
#include "ControllerRanks.h"
#include "Ranks/WorkTogether.h"

class vtkAlgorithm;
class vtkInformationVector;
class vtkMultiProcessController;

namespace vfm
{

class FilterRuntime : public ThreadRuntime
{
public:
  /// ranks: null for one process; must outlive this.
  FilterRuntime(vtkAlgorithm* owner, int threads, Ranks* ranks = nullptr) :
    ThreadRuntime(threads, ranks), Owner(owner)
  {
  }

  /// Does not stop when there are several ranks: the others would wait for this one.
  void Progress(double fraction, const char* stage) override;

  /// Does the work(ranks) of a RequestData, together with the other processes of the controller. When it throws on any, the outputs are
  /// emptied on all and, unless it was Aborted, say why (FailedOutput), and each owner reports the same error.
  template <class Work>
  static void Execute(vtkAlgorithm* owner, vtkMultiProcessController* controller,
    vtkInformationVector* outputs, const Work& work)
  {
    const auto together = [&]
    {
      ControllerRanks ranks(controller);
      WorkTogether(ranks, [&] { work(ranks); });
    };
    Report(owner, outputs, std::cref(together)); // by reference: takes no memory
  }

private:
  static void Report(
    vtkAlgorithm* owner, vtkInformationVector* outputs, const std::function<void()>& work);

  vtkAlgorithm* Owner;
};

} // namespace vfm
