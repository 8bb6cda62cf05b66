#include "Stage.h"

#include <new>

namespace vfm
{
namespace
{

ProgramError FindFailure(ExitCode code, const std::function<void()>& work)
{
  try
  {
    work();
    return { ExitCode::Good, "" };
  }
  catch (const ProgramError& error)
  {
    return error;
  }
  catch (const std::bad_alloc&)
  {
    return { ExitCode::InternalError, "Not enough memory." };
  }
  catch (const std::exception& error)
  {
    return { code, error.what() };
  }
}

} // namespace

void WorkInStage(Ranks& ranks, ExitCode code, const std::function<void()>& work)
{
  const ProgramError mine = FindFailure(code, work);
  if (!ranks.Any(mine.Code != ExitCode::Good))
  {
    return;
  }
  const std::string text = static_cast<char>(mine.Code) + std::string(mine.what());
  for (const Bytes& failure : ranks.Gather(Bytes(text.begin(), text.end())))
  {
    const ExitCode failed = static_cast<ExitCode>(failure[0]);
    if (failed != ExitCode::Good)
    {
      throw ProgramError(failed, std::string(failure.begin() + 1, failure.end()));
    }
  }
}

} // namespace vfm
