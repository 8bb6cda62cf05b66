#include "Agreement.h"

#include "Base/Runtime.h"

#include <new>
#include <string>

namespace vfm
{
namespace
{

/// The message of a failure of the work; empty when it went well.
std::string FindFailure(const std::function<void()>& work)
{
  try
  {
    work();
    return "";
  }
  catch (const Aborted&)
  {
    throw;
  }
  catch (const std::bad_alloc&)
  {
    return "Not enough memory for the mesh.";
  }
  catch (const std::exception& error)
  {
    return error.what();
  }
}

} // namespace

void WorkTogether(Ranks& ranks, const std::function<void()>& work)
{
  const std::string mine = FindFailure(work);
  if (!ranks.Any(!mine.empty()))
  {
    return;
  }
  for (const Bytes& message : ranks.Gather(Bytes(mine.begin(), mine.end())))
  {
    if (!message.empty())
    {
      throw InputError(std::string(message.begin(), message.end()));
    }
  }
}

} // namespace vfm
