/**
 * StageClock: the stages of a pipeline, timed.
 */
#pragma once

#include "Base/Runtime.h"
#include "Mesh/MeshReport.h"

#include <chrono>

namespace vfm
{

/// Names the running stage, times it and tells the progress.
class StageClock
{
public:
  StageClock(Runtime& runtime, MeshReport& report) : Run(runtime), Report(report) {}
  ~StageClock() { this->Stop(); }
  void Start(const char* name, double fraction)
  {
    this->Stop();
    this->Report.Stages.push_back({ name, 0.0 });
    this->Begin = std::chrono::steady_clock::now();
    this->Update(fraction);
  }
  void Update(double fraction)
  {
    this->Run.Progress(this->Share * fraction, this->Report.Stages.back().Name);
  }
  /// What part of the whole run the fractions are of, from now on.
  void SetShare(double share) { this->Share = share; }

private:
  void Stop()
  {
    if (!this->Report.Stages.empty())
    {
      this->Report.Stages.back().Seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - this->Begin).count();
    }
  }
  Runtime& Run;
  MeshReport& Report;
  double Share = 1.0;
  std::chrono::steady_clock::time_point Begin;
};

} // namespace vfm
