/**
 * FilterRuntime: progress and abort through a vtkAlgorithm, and error handling of RequestData.
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
  /// owner and ranks must outlive this object; ranks null: a single rank.
  FilterRuntime(vtkAlgorithm* owner, int threads, Ranks* ranks = nullptr) :
    ThreadRuntime(threads, ranks), Owner(owner)
  {
  }

  /// Reports progress. Throws Aborted if the user aborts, except on several ranks: the others would
  /// wait for this one.
  void Progress(double fraction, const char* stage) override;

  /// Calls work(ranks) for RequestData, together with the other ranks of the controller. If it
  /// throws on any rank, the outputs are empty on all ranks. Unless the error is Aborted, the
  /// outputs hold the message (FailedOutput), and each owner reports it.
  template <class Work>
  static void Execute(vtkAlgorithm* owner, vtkMultiProcessController* controller,
    vtkInformationVector* outputs, const Work& work)
  {
    const auto together = [&]
    {
      ControllerRanks ranks(controller);
      WorkTogether(ranks, [&] { work(ranks); });
    };
    Report(owner, outputs, std::cref(together)); // a reference needs no memory
  }

private:
  static void Report(
    vtkAlgorithm* owner, vtkInformationVector* outputs, const std::function<void()>& work);

  vtkAlgorithm* Owner;
};

} // namespace vfm
