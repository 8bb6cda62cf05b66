/**
 * AgreeOnErrors: what failed on any rank becomes a line of text on all.
 */
#pragma once

#include "Ranks/WorkTogether.h"

#include <string>

namespace vfm
{

void AddLine(std::string& text, const std::string& line);

/// Collective: does the work(), which may throw InputError on any rank, and adds what it told to the errors. Whether it went well
/// everywhere.
template <class Work>
bool Agree(Ranks& ranks, const Work& work, std::string& errors)
{
  try
  {
    WorkTogether(ranks, work, Ranks::Frame::Stage);
    return true;
  }
  catch (const InputError& error)
  {
    AddLine(errors, error.what());
    return false;
  }
}

/// What an adaptor tells of failures.
struct Failures
{
  std::string LeftOut; ///< for good
  std::string Failed;  ///< in the step that was asked for last
  /// All lines; they stay until it is asked again.
  const std::string& Tell();

private:
  std::string All;
};

/// Collective: whether all ranks can read the script; adds that they cannot to the errors.
bool CanRead(const std::string& script, Ranks& ranks, std::string& errors);

} // namespace vfm
