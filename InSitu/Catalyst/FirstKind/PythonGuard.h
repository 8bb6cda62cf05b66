/**
 * PythonGuard: what Python code prints as errors, and scripts that may not end the process.
 */
#pragma once

#include "vtkSmartPointer.h"

#include <string>

class vtkCallbackCommand;
class vtkObject;
class vtkPythonInterpreter;

namespace vfm
{

class PythonGuard
{
public:
  PythonGuard();
  ~PythonGuard();
  PythonGuard(const PythonGuard&) = delete;
  PythonGuard& operator=(const PythonGuard&) = delete;

  /// Makes every exception of a Catalyst script, SystemExit too, an error that names the script. Call once Python runs.
  void GuardScripts();

  /// What was printed of errors since the last call, without the traces of calls: of each script that failed a line; if
  /// none did, the last line.
  std::string TakeErrors();

private:
  static void Take(vtkObject* caller, unsigned long event, void* self, void* text);

  vtkSmartPointer<vtkPythonInterpreter> Interpreter;
  vtkSmartPointer<vtkCallbackCommand> Observer;
  std::string Printed;
};

} // namespace vfm
