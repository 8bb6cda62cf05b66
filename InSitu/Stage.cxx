#include "Stage.h"

#include "Ranks/WorkTogether.h"

#include <new>

namespace vfm
{
namespace
{

/// Makes errors that carry their code to other ranks.
void WorkWithCode(ExitCode code, const std::function<void()>& work)
{
  try
  {
    work();
  }
  catch (const ProgramError& error)
  {
    throw InputError(error.what(), static_cast<int>(error.Code));
  }
  catch (const InputError& error)
  {
    throw InputError(error.what(), error.Code() ? error.Code() : static_cast<int>(code));
  }
  catch (const std::bad_alloc&)
  {
    throw;
  }
  catch (const std::exception& error)
  {
    throw InputError(error.what(), static_cast<int>(code));
  }
}

} // namespace

void WorkInStage(Ranks& ranks, Ranks::Frame frame, ExitCode code, const std::function<void()>& work)
{
  try
  {
    WorkTogether(
      ranks, [&] { WorkWithCode(code, work); }, frame);
  }
  catch (const InputError& error)
  {
    const bool hasCode = error.Code() > 0;
    throw ProgramError(
      hasCode ? static_cast<ExitCode>(error.Code()) : ExitCode::InternalError, error.what());
  }
}

} // namespace vfm
