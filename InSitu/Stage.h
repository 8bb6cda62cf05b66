/**
 * Stage: what programs and hosts are told when reading, meshing or writing fails, and steps of work that all ranks end alike.
 */
#pragma once

#include "Ranks/Ranks.h"

#include <functional>
#include <stdexcept>
#include <string>

namespace vfm
{

/// Also the exit status of the program sculptor.
enum class ExitCode
{
  Good = 0,
  WrongArguments = 1,
  UnreadableInput = 2,
  RefusedMesh = 3,
  UnwritableOutput = 4,
  InternalError = 5 ///< also lack of memory
};

/// Ends the program; thrown on all ranks, with the same code and message.
struct ProgramError : std::runtime_error
{
  ProgramError(ExitCode code, const std::string& message) : std::runtime_error(message), Code(code)
  {
  }
  ExitCode Code;
};

/// As below; the work is not copied.
void WorkInStage(
  Ranks& ranks, Ranks::Frame frame, ExitCode code, const std::function<void()>& work);

/// Collective: every rank does its work, as in WorkTogether. When it fails on any rank, all throw ProgramError with the message and code of
/// the lowest that failed: code for a std::exception, InternalError for lack of memory, a ProgramError's own.
template <class Work>
void WorkInStage(
  Ranks& ranks, ExitCode code, const Work& work, Ranks::Frame frame = Ranks::Frame::Stage)
{
  WorkInStage(ranks, frame, code, std::cref(work)); // takes no memory
}

} // namespace vfm
