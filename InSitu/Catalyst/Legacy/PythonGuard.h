/**
 * PythonGuard: collects the errors that Python prints, and keeps scripts from ending the process.
 */
#pragma once

#include "vtkSmartPointer.h"

#include <string>

class vtkCallbackCommand;
class vtkObject;
class vtkPythonInterpreter;

namespace vfm
{

/// Observer of the Python interpreter. Python's errors are collected during its lifetime.
class PythonGuard
{
public:
  PythonGuard();
  ~PythonGuard();
  PythonGuard(const PythonGuard&) = delete;
  PythonGuard& operator=(const PythonGuard&) = delete;

  /// Turns each exception of a Catalyst script, also SystemExit, into an error with the name of the
  /// script. Python must be running.
  void GuardScripts();

  /// Returns the errors printed since the last call, without tracebacks: one line per script that
  /// failed, or the last line if none did.
  std::string TakeErrors();

private:
  static void Take(vtkObject* caller, unsigned long event, void* self, void* text);

  vtkSmartPointer<vtkPythonInterpreter> Interpreter;
  vtkSmartPointer<vtkCallbackCommand> Observer;
  std::string Printed;
};

} // namespace vfm
