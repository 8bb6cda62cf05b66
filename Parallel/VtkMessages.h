/**
 * VtkMessages: what VTK objects report, kept as plain sentences instead of being printed.
 *
 * Not a vtkObject; watch and ask from one thread. Observers are taken off when this ends.
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

/// A VTK message without "ERROR: In file, line", the class with its address, and blank ends.
std::string CleanVtkMessage(const std::string& message);

class VtkMessages
{
public:
  VtkMessages();
  ~VtkMessages();
  VtkMessages(const VtkMessages&) = delete;
  VtkMessages& operator=(const VtkMessages&) = delete;

  /// From now on errors and warnings of the object, of an algorithm also its executive's, come here and are not printed.
  void Watch(vtkObject* object);

  /// In the order they came; each once. That an algorithm failed counts only when nothing else tells why.
  const std::vector<std::string>& GetErrors() const;
  const std::vector<std::string>& GetWarnings() const { return this->Warnings; }
  bool HasErrors() const { return !this->GetErrors().empty(); }
  /// All errors as one line, or an empty text.
  std::string GetErrorText() const;

  void AddError(const std::string& message);
  void AddWarning(const std::string& message);

private:
  static void Take(vtkObject* caller, unsigned long event, void* self, void* text);

  std::vector<std::string> Errors, Failures, Warnings;
  vtkSmartPointer<vtkCallbackCommand> Observer;
  std::vector<vtkWeakPointer<vtkObject>> Watched;
};

/// While this lives VTK prints nothing at all, in the whole process: errors and warnings of objects that nobody watches
/// go to the messages, which must outlive this. For programs; not for libraries in a host.
class VtkSilence
{
public:
  explicit VtkSilence(VtkMessages& messages);
  ~VtkSilence();
  VtkSilence(const VtkSilence&) = delete;
  VtkSilence& operator=(const VtkSilence&) = delete;
};

} // namespace vfm
