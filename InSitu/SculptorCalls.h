/**
 * SculptorCalls: common code of the calls of Sculptor.h and CMLPSculptor.c.h. It maps handles to
 * the sculptors of the process and exceptions to codes. Functions throw only where they say so.
 */
#pragma once

#include "Sculptor.h"
#include "SculptorSession.h"

#include "Ranks/Errors.h"

#include <memory>

namespace vfm
{

/// Code of the last call, and message of the last call that failed.
class LastCall
{
public:
  /// Runs work() and converts an exception to a code and a message.
  /// @return SculptorCode
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
  /// Returns the message of the last call that failed.
  const std::string& GetText() const { return this->Text; }

private:
  /// Sets the code and message of the exception that is being handled.
  void Report() noexcept;
  void Set(int code, const char* text) noexcept;

  int Code = SCULPTOR_OK;
  std::string Text;
};

/// Sculptor of a handle.
struct Sculptor
{
  SculptorSession Session;
  LastCall Call; ///< last call with this handle
};

/// Creates a sculptor.
/// @return handle, from 1
/// @throws std::bad_alloc
int AddSculptor();
/// Returns the sculptor of a handle, or null.
std::shared_ptr<Sculptor> FindSculptor(int handle);
/// Deletes the sculptor of a handle.
/// @throws InputError  if the handle is invalid
/// @pre Collective if the sculptor has made a mesh, because its communicator is freed
void RemoveSculptor(int handle);

/// Returns the last call of this thread without a valid handle: creation, deletion, or a call with
/// an invalid handle.
LastCall& CallWithoutSculptor();
/// Records a call with an invalid handle.
/// @return SCULPTOR_ERROR_HANDLE
int RejectHandle(int handle);

/// Runs work(session) with the session of a handle.
/// @return SculptorCode
template <class Work>
int WithSession(int handle, const Work& work)
{
  const std::shared_ptr<Sculptor> sculptor = FindSculptor(handle);
  return sculptor ? sculptor->Call.Do([&] { work(sculptor->Session); }) : RejectHandle(handle);
}

/// Returns the pointer.
/// @throws InputError  with the name of the argument, if the pointer is null
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
