/**
 * SculptorCalls: what the calls of the C interface, those of Sculptor.h and of CMLPSculptor.c.h, share: the sculptors of the
 * process by their handles, and the end of every exception. No function here throws but where it says so.
 */
#pragma once

#include "Sculptor.h"
#include "SculptorSession.h"

#include "Ranks/Errors.h"

#include <memory>

namespace vfm
{

/// What became of the last call.
class LastCall
{
public:
  /// Does the work; what it throws becomes a code, which is returned, and a text.
  template <class Work>
  int Do(const Work& work)
  {
    this->Code = SCULPTOR_OK;
    try
    {
      work();
    }
    catch (...)
    {
      this->Report();
    }
    return this->Code;
  }
  int GetCode() const { return this->Code; }
  /// Of the last call that failed.
  const std::string& GetText() const { return this->Text; }

private:
  /// Of the exception in flight.
  void Report() noexcept;
  void Set(int code, const char* text) noexcept;

  int Code = SCULPTOR_OK;
  std::string Text;
};

struct Sculptor
{
  SculptorSession Session;
  LastCall Call; ///< with this sculptor
};

/// A new one; its handle, from 1. Throws when memory is short.
int AddSculptor();
/// Null when there is none.
std::shared_ptr<Sculptor> FindSculptor(int handle);
/// Throws InputError when there is none.
void RemoveSculptor(int handle);

/// Of this thread: to create, to delete, or with a handle that no sculptor has.
LastCall& CallWithoutSculptor();
int RejectHandle(int handle);

/// Does the work with the session of a handle; returns the code.
template <class Work>
int WithSession(int handle, const Work& work)
{
  const std::shared_ptr<Sculptor> sculptor = FindSculptor(handle);
  return sculptor ? sculptor->Call.Do([&] { work(sculptor->Session); }) : RejectHandle(handle);
}

/// The pointer; throws InputError with the argument's name when it is null.
template <class T>
T* NotNull(T* pointer, const char* name)
{
  if (!pointer)
  {
    throw InputError(std::string(name) + " is a null pointer.");
  }
  return pointer;
}

} // namespace vfm
