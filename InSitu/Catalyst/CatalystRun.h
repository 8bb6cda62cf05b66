/**
 * CatalystRun: runs Catalyst inside a process, base of legacy Catalyst and Catalyst 2.
 */
#pragma once

#include "CatalystAdaptor.h"
#include "MpiTransport.h"
#include "Ranks/WorkTogether.h"

namespace vfm
{

/// Step of the simulation.
struct HostStep
{
  double Time;
  int Number;
  bool IsLast; ///< no other step follows
};

/// Appends a line to a text, unless the line is empty.
void AddLine(std::string& text, const std::string& line);

/// Catalyst in a process. All calls are collective. A failure on any rank is recorded on each rank.
class CatalystRun
{
public:
  explicit CatalystRun(MPI_Comm communicator);
  virtual ~CatalystRun();

  /// Passes a step to the scripts, see CatalystAdaptor::Process; returns false if the step failed.
  virtual bool Process(
    const HostGrid& grid, const HostStep& step, const std::vector<HostNumber>& numbers) = 0;

  std::string LeftOut; ///< permanent failures, one per line
  std::string Failed;  ///< failures of the last step, one per line
  int StepsMade = 0;

protected:
  /// Calls work(), which may throw InputError on any rank. Returns whether it succeeded on all
  /// ranks; otherwise appends the message to `errors`.
  template <class Work>
  bool Agree(const Work& work, std::string& errors)
  {
    try
    {
      WorkTogether(this->Group, work, Ranks::Frame::Stage);
      return true;
    }
    catch (const InputError& error)
    {
      AddLine(errors, error.what());
      return false;
    }
  }

  /// Returns whether all ranks can read a script; otherwise adds a permanent failure.
  bool CanRead(const std::string& script);

  /// Records that Catalyst cannot start a second time.
  void RejectStart();

  static bool HasStarted; // ParaView cannot start again after it has ended
  MPI_Comm Communicator;  // duplicate of the simulation's communicator
  MpiRanks Group;
};

/// Starts Catalyst; defined by the library of the build.
std::unique_ptr<CatalystRun> StartCatalyst(
  MPI_Comm communicator, const std::vector<std::string>& scripts);

} // namespace vfm
