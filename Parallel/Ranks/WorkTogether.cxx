#include "Ranks/WorkTogether.h"

#include "Ranks/Errors.h"

#include <new>

namespace vfm
{
void WorkTogether(Ranks& ranks, Ranks::Frame frame, void (*work)(void*), void* what)
{
  if (!ranks.Enter(frame))
  {
    work(what);
    return;
  }
  try
  {
    work(what);
    ranks.Leave();
  }
  catch (const Aborted& error)
  {
    if (ranks.Count() == 1)
    {
      ranks.Leave();
      throw;
    }
    ranks.Fail({ ranks.Rank(), ErrorCode::Unknown, error.what() });
  }
  catch (const InputError& error)
  {
    ranks.Fail({ ranks.Rank(), error.Code(), error.what() });
  }
  catch (const std::bad_alloc&)
  {
    ranks.Fail(LackOfMemory(ranks.Rank(), ranks.Count()));
  }
  catch (const std::exception& error)
  {
    ranks.Fail({ ranks.Rank(), ErrorCode::Unknown, error.what() });
  }
  catch (...)
  {
    ranks.Fail({ ranks.Rank(), ErrorCode::Unknown, "An unknown failure." });
  }
}

} // namespace vfm
