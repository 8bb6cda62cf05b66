/**
 * StageClock: times the stages of a pipeline.
 */
#pragma once

#include "Base/Runtime.h"
#include "Elements/MeshReport.h"

#include <algorithm>
#include <chrono>

namespace vfm
{

/// Clock of the running stage. It adds each stage to MeshReport::Stages and reports the progress.
class StageClock
{
public:
  StageClock(Runtime& runtime, MeshReport& report) : Run(runtime), Report(report) {}
  ~StageClock() { this->Stop(); }
  /// Ends the running stage and begins another.
  /// @param name  string literal
  /// @param fraction  progress, 0 to 1
  void Start(const char* name, double fraction)
  {
    this->Stop();
    this->Report.Stages.push_back({ name, 0.0 });
    this->Begin = std::chrono::steady_clock::now();
    this->Update(fraction);
  }
  /// Reports progress inside the running stage. It does not go back where a stage occurs again.
  void Update(double fraction)
  {
    this->Farthest = std::max(this->Farthest, this->Share * fraction);
    this->Run.Progress(this->Farthest, this->Report.Stages.back().Name);
  }
  /// Sets the share of the whole run that later fractions are relative to.
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
  double Share = 1.0, Farthest = 0.0;
  std::chrono::steady_clock::time_point Begin;
};

} // namespace vfm
