#include "FilterRuntime.h"

#include "ControllerRanks.h"

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"
#include "vtkSMPTools.h"

#include <exception>
#include <mutex>
#include <new>

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

int ChooseThreads(vtkMultiProcessController* controller, int wanted)
{
  return wanted > 0 || ControllerRanks(controller).Count() == 1 ? wanted : 1;
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

int FilterRuntime::Execute(vtkAlgorithm* owner, vtkMultiProcessController* controller, int threads,
  const std::vector<vtkDataObject*>& outputs, const std::function<void()>& work)
{
  const int count = ChooseThreads(controller, threads);
  std::string problem;
  try
  {
    vtkSMPTools::LocalScope(
      vtkSMPTools::Config{ count, ThreadBackend(count), false }, [&] { work(); });
    return 1;
  }
  catch (const Aborted&)
  {
  }
  catch (const InputError& error)
  {
    problem = error.what();
  }
  catch (const std::bad_alloc&)
  {
    problem = "Not enough memory.";
  }
  for (vtkDataObject* output : outputs)
  {
    output->Initialize();
  }
  if (!problem.empty())
  {
    vtkErrorWithObjectMacro(owner, << problem);
  }
  return problem.empty() ? 1 : 0;
}

} // namespace vfm
