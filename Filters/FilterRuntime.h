/**
 * FilterRuntime: loops of the Grid code on vtkSMPTools, progress and abort through a vtkAlgorithm, the ranks that
 * work on one grid, and the frame of RequestData around the Grid code.
 */
#pragma once

#include "Base/Runtime.h"

#include <vector>

class vtkAlgorithm;
class vtkDataObject;
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

  /// An exception in the body is thrown on, once all threads have ended.
  void For(std::int64_t first, std::int64_t last,
    const std::function<void(std::int64_t, std::int64_t)>& body) override;
  /// Does not stop when there are several ranks: the others would wait for this one.
  void Progress(double fraction, const char* stage) override;

  /// Does the work of a RequestData and returns what that returns. When the work throws, the outputs are emptied and, unless
  /// it was Aborted, the owner reports one error. threads: 0 for all cores on one process, one thread on each of several.
  static int Execute(vtkAlgorithm* owner, vtkMultiProcessController* controller, int threads,
    const std::vector<vtkDataObject*>& outputs, const std::function<void()>& work);

private:
  vtkAlgorithm* Owner;
  Ranks* TheRanks;
};

} // namespace vfm
