#include "FilterRuntime.h"

#include "EmptyOutput.h"
#include "FailedOutput.h"

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkSMPTools.h"

#include <cstring>
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
  const int threads = vtkSMPTools::GetEstimatedNumberOfThreads();
  if (last - first < 2 || threads < 2 || this->IsLooping)
  {
    this->Runtime::For(first, last, body);
    return;
  }
  // not by vtkSMPTools, which with this backend ends the process where memory or threads run out
  if (std::strcmp(vtkSMPTools::GetBackend(), "STDThread") == 0)
  {
    this->Threads.For(threads, first, last, body);
    return;
  }
  ExceptionKeeper keeper;
  auto range = [&](std::int64_t begin, std::int64_t end) { keeper.Run([&] { body(begin, end); }); };
  this->IsLooping = true;
  vtkSMPTools::For(first, last, range);
  this->IsLooping = false;
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

int FilterRuntime::ChooseThreads(vtkMultiProcessController* controller, int wanted)
{
  return wanted > 0 || !controller || controller->GetNumberOfProcesses() == 1 ? wanted : 1;
}

void FilterRuntime::WithThreads(int threads, const std::function<void()>& work)
{
  vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads, ThreadBackend(threads), false }, work);
}

void FilterRuntime::Report(
  vtkAlgorithm* owner, vtkInformationVector* outputs, const std::function<void()>& work)
{
  owner->SetAbortExecute(0); // of an earlier run
  try
  {
    work();
  }
  catch (const Aborted&)
  {
    for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
    {
      EmptyOutput(outputs->GetInformationObject(port));
    }
  }
  catch (const InputError& error)
  {
    Fail(owner, outputs, error.what());
  }
}

} // namespace vfm
