/**
 * VtkMessages: stores the errors and warnings of VTK objects instead of printing them.
 */
#pragma once

#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <string>
#include <vector>

class vtkCallbackCommand;
class vtkObject;

namespace vfm
{

/// Returns a VTK message without "ERROR: In file, line", without the class and
/// its address, and trimmed.
std::string CleanVtkMessage(const std::string& message);

/// Errors and warnings of observed VTK objects, as plain sentences. The destructor removes the
/// observers. It is not thread-safe.
class VtkMessages
{
public:
  VtkMessages();
  ~VtkMessages();
  VtkMessages(const VtkMessages&) = delete;
  VtkMessages& operator=(const VtkMessages&) = delete;

  /// Stores later errors and warnings of an object, and of the executive of an algorithm,
  /// instead of printing them.
  void Watch(vtkObject* object);

  /// Returns the errors in their order, without duplicates. Messages that an algorithm failed are
  /// included only if there is no other error.
  const std::vector<std::string>& GetErrors() const;
  const std::vector<std::string>& GetWarnings() const { return this->Warnings; }
  bool HasErrors() const { return !this->GetErrors().empty(); }
  /// Returns all errors as one line; empty if there are none.
  std::string GetErrorText() const;

  void AddError(const std::string& message);
  void AddWarning(const std::string& message);

private:
  static void Take(vtkObject* caller, unsigned long event, void* self, void* text);

  std::vector<std::string> Errors, Failures, Warnings;
  vtkSmartPointer<vtkCallbackCommand> Observer;
  std::vector<vtkWeakPointer<vtkObject>> Watched;
};

/// Suppresses all output of VTK in the whole process as long as it exists. Errors and warnings of
/// objects that are not observed are added to the messages, which must outlive this object. It is
/// made for programs, not for libraries inside a host.
class VtkSilence
{
public:
  explicit VtkSilence(VtkMessages& messages);
  ~VtkSilence();
  VtkSilence(const VtkSilence&) = delete;
  VtkSilence& operator=(const VtkSilence&) = delete;
};

} // namespace vfm
