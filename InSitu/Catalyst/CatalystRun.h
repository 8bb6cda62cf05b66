/**
 * CatalystRun: Catalyst inside a process, of one kind or the other. What fails on any rank becomes a line of text on all.
 */
#pragma once

#include "CatalystAdaptor.h"
#include "MpiTransport.h"
#include "Ranks/WorkTogether.h"

namespace vfm
{

struct HostStep
{
  double Time;
  int Number;
  bool IsLast; ///< no other step follows
};

/// Adds a line to lines of text, unless it is empty.
void AddLine(std::string& text, const std::string& line);

/// All calls are collective.
class CatalystRun
{
public:
  explicit CatalystRun(MPI_Comm communicator);
  virtual ~CatalystRun();

  /// As CatalystAdaptor::Process; false where the step failed.
  virtual bool Process(
    const HostGrid& grid, const HostStep& step, const std::vector<HostNumber>& numbers) = 0;

  std::string LeftOut; ///< failures for good, a line each
  std::string Failed;  ///< failures of the last step, a line each
  int StepsMade = 0;

protected:
  /// Whether the work(), which may throw InputError on any rank, went well everywhere; adds what failed to the errors.
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

  /// Whether all ranks can read the script; else it is left out.
  bool CanRead(const std::string& script);

  void RejectStart();

  static bool HasStarted; // ParaView cannot start again after it has ended
  MPI_Comm Communicator;  // a duplicate
  MpiRanks Group;
};

/// Defined by each kind.
std::unique_ptr<CatalystRun> StartCatalyst(
  MPI_Comm communicator, const std::vector<std::string>& scripts);

} // namespace vfm
