#include "FilterRuntime.h"

#include "vtkAlgorithm.h"
#include "vtkSMPTools.h"

#include <exception>
#include <mutex>

namespace vfm
{
namespace
{

/// Keeps the first exception of several threads.
class ExceptionKeeper
{
public:
  template <class Work>
  void Run(Work&& work)
  {
    try
    {
      work();
    }
    catch (...)
    {
      const std::lock_guard<std::mutex> lock(this->Mutex);
      if (!this->First)
      {
        this->First = std::current_exception();
      }
    }
  }
  void Rethrow()
  {
    if (this->First)
    {
      std::rethrow_exception(this->First);
    }
  }

private:
  std::mutex Mutex;
  std::exception_ptr First;
};

/// ParaView of Debian starts with the backend Sequential.
std::string ThreadBackend(int threads)
{
  const std::string current = vtkSMPTools::GetBackend();
#if VTK_SMP_ENABLE_STDTHREAD
  if (current == "Sequential" && threads != 1)
  {
    return "STDThread";
  }
#endif
  return threads == 1 ? "Sequential" : current;
}

} // namespace

void FilterRuntime::For(std::int64_t first, std::int64_t last,
  const std::function<void(std::int64_t, std::int64_t)>& body)
{
  ExceptionKeeper keeper;
  auto range = [&](vtkIdType begin, vtkIdType end) { keeper.Run([&] { body(begin, end); }); };
  vtkSMPTools::For(first, last, range);
  keeper.Rethrow();
}

void FilterRuntime::Progress(double fraction, const char* stage)
{
  this->Owner->SetProgressText(stage);
  this->Owner->UpdateProgress(fraction);
  if (this->Owner->GetAbortExecute() && this->Group().Count() == 1)
  {
    throw Aborted();
  }
}

void FilterRuntime::WithThreads(int threads, const std::function<void()>& work)
{
  vtkSMPTools::LocalScope(
    vtkSMPTools::Config{ threads, ThreadBackend(threads), false }, [&] { work(); });
}

} // namespace vfm
