/**
 * FilterRuntime: loops of the Grid code on threads, progress and abort through a vtkAlgorithm, the ranks that
 * work on one grid, and the frame of RequestData around the Grid code.
 */
#pragma once

#include "Base/LoopThreads.h"
#include "Base/Runtime.h"
#include "ControllerRanks.h"
#include "Ranks/WorkTogether.h"

class vtkAlgorithm;
class vtkInformationVector;
class vtkMultiProcessController;

namespace vfm
{

class FilterRuntime : public Runtime
{
public:
  /// ranks: null for one process; must outlive this.
  explicit FilterRuntime(vtkAlgorithm* owner, Ranks* ranks = nullptr) :
    Owner(owner), TheRanks(ranks)
  {
  }

  Ranks& Group() override { return this->TheRanks ? *this->TheRanks : this->Runtime::Group(); }

  /// An exception in the body is thrown on, once all threads have ended. Threads that the system does not give are done without.
  void For(std::int64_t first, std::int64_t last,
    const std::function<void(std::int64_t, std::int64_t)>& body) override;
  /// Does not stop when there are several ranks: the others would wait for this one.
  void Progress(double fraction, const char* stage) override;

  /// Does the work(ranks) of a RequestData, together with the other processes of the controller. When it throws on any, the outputs are
  /// emptied on all and, unless it was Aborted, say why (FailedOutput), and each owner reports the same error.
  template <class Work>
  static void Execute(vtkAlgorithm* owner, vtkMultiProcessController* controller, int threads,
    vtkInformationVector* outputs, const Work& work)
  {
    const auto together = [&]
    {
      ControllerRanks ranks(controller);
      const auto threaded = [&] { work(ranks); };
      WorkTogether(ranks, [&] { WithThreads(threads, std::cref(threaded)); });
    };
    Report(owner, outputs, std::cref(together)); // by reference: takes no memory
  }

  /// 0: all cores on one process, one thread on each of several.
  static int ChooseThreads(vtkMultiProcessController* controller, int wanted);

private:
  static void WithThreads(int threads, const std::function<void()>& work);
  static void Report(
    vtkAlgorithm* owner, vtkInformationVector* outputs, const std::function<void()>& work);

  vtkAlgorithm* Owner;
  Ranks* TheRanks;
  LoopThreads Threads;
  bool IsLooping = false; // loops inside of loops of vtkSMPTools take one thread
};

} // namespace vfm
