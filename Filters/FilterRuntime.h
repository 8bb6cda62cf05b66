/**
 * FilterRuntime: loops of the Grid code on vtkSMPTools, progress and abort through a vtkAlgorithm, and the ranks
 * that work on one grid.
 */
#pragma once

#include "Runtime.h"

#include <string>

class vtkAlgorithm;

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

  /// Calls work with vtkSMPTools set to that many threads, 0 for all cores. Exceptions are thrown on.
  static void WithThreads(int threads, const std::function<void()>& work);

private:
  vtkAlgorithm* Owner;
  Ranks* TheRanks;
};

} // namespace vfm
