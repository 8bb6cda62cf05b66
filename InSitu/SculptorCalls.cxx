#include "SculptorCalls.h"

#include <mutex>

namespace vfm
{
namespace
{

struct SculptorTable
{
  std::mutex Mutex;
  std::map<int, std::shared_ptr<Sculptor>> Sculptors;
  int Last = 0;
};

SculptorTable& Table()
{
  static SculptorTable* table = new SculptorTable; // never deleted: static objects may still use it
  return *table;
}

InputError WrongHandle(int handle)
{
  return { ErrorCode::WrongHandle,
    "There is no sculptor " + std::to_string(handle) +
      ": it was never created, or has been deleted." };
}

/// Returns the code of the C interface.
int CodeOf(ErrorCode code)
{
  switch (code)
  {
    case ErrorCode::Unknown:
    case ErrorCode::WrongArguments:
      return SCULPTOR_ERROR_ARGUMENT;
    case ErrorCode::UnreadableInput:
    case ErrorCode::RejectedMesh:
      return SCULPTOR_ERROR_INPUT;
    case ErrorCode::UnwritableOutput:
      return SCULPTOR_ERROR_FILE;
    case ErrorCode::InternalError:
      return SCULPTOR_ERROR_INTERNAL;
    case ErrorCode::OutOfMemory:
      return SCULPTOR_ERROR_MEMORY;
    case ErrorCode::NoMesh:
      return SCULPTOR_ERROR_NO_MESH;
    case ErrorCode::TooLarge:
      return SCULPTOR_ERROR_SIZE;
    case ErrorCode::WrongHandle:
      return SCULPTOR_ERROR_HANDLE;
  }
  return SCULPTOR_ERROR_INTERNAL;
}

} // namespace

void LastCall::Report() noexcept
{
  try
  {
    throw;
  }
  catch (const InputError& error)
  {
    this->Set(CodeOf(error.Code()), error.what());
  }
  catch (const std::bad_alloc&)
  {
    this->Set(SCULPTOR_ERROR_MEMORY, "Not enough memory.");
  }
  catch (const std::exception& error)
  {
    this->Set(SCULPTOR_ERROR_INTERNAL, error.what());
  }
  catch (...)
  {
    this->Set(SCULPTOR_ERROR_INTERNAL, "An unknown failure.");
  }
}

void LastCall::Set(int code, const char* text) noexcept
{
  this->Code = code;
  try
  {
    this->Text = text;
  }
  catch (const std::bad_alloc&)
  {
    this->Text.clear(); // only the code is reported
  }
}

int AddSculptor()
{
  auto sculptor = std::make_shared<Sculptor>();
  SculptorTable& table = Table();
  const std::lock_guard<std::mutex> lock(table.Mutex);
  table.Sculptors.emplace(table.Last + 1, std::move(sculptor));
  return ++table.Last;
}

std::shared_ptr<Sculptor> FindSculptor(int handle)
{
  SculptorTable& table = Table();
  const std::lock_guard<std::mutex> lock(table.Mutex);
  const auto found = table.Sculptors.find(handle);
  return found == table.Sculptors.end() ? nullptr : found->second;
}

void RemoveSculptor(int handle)
{
  std::shared_ptr<Sculptor> last; // destroyed after the lock is released
  SculptorTable& table = Table();
  const std::lock_guard<std::mutex> lock(table.Mutex);
  const auto found = table.Sculptors.find(handle);
  if (found == table.Sculptors.end())
  {
    throw WrongHandle(handle);
  }
  last = std::move(found->second);
  table.Sculptors.erase(found);
}

LastCall& CallWithoutSculptor()
{
  thread_local LastCall call;
  return call;
}

int RejectHandle(int handle)
{
  return CallWithoutSculptor().Do([=] { throw WrongHandle(handle); });
}

} // namespace vfm
