#include "PythonGuard.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkPythonInterpreter.h"

#include <sstream>

namespace vfm
{
namespace
{

// Catalyst calls scripts through these functions and prints their exceptions. Printing a SystemExit
// would end the process.
constexpr const char* GuardCode = R"(
def _vfm_guard():
    import functools
    from paraview.catalyst import v2_internals

    def guard(function):
        @functools.wraps(function)
        def guarded(*arguments):
            try:
                return function(*arguments)
            except BaseException as error:
                script = v2_internals._get_script_filename() or "of Catalyst"
                what = " ".join(str(error).split())
                raise RuntimeError(
                    "Script %s: %s: %s" % (script, type(error).__name__, what)) from error
        guarded.is_guarded = True
        return guarded

    for name in ("import_and_validate", "do_request_data_description", "do_catalyst_initialize",
                 "do_catalyst_execute", "do_catalyst_finalize"):
        function = getattr(v2_internals, name)
        if not hasattr(function, "is_guarded"):
            setattr(v2_internals, name, guard(function))

_vfm_guard()
del _vfm_guard
)";

} // namespace

PythonGuard::PythonGuard() :
  Interpreter(vtkSmartPointer<vtkPythonInterpreter>::New()),
  Observer(vtkSmartPointer<vtkCallbackCommand>::New())
{
  this->Observer->SetClientData(this);
  this->Observer->SetCallback(&PythonGuard::Take);
  this->Interpreter->AddObserver(vtkCommand::ErrorEvent, this->Observer);
}

PythonGuard::~PythonGuard()
{
  this->Interpreter->RemoveObserver(this->Observer);
}

void PythonGuard::GuardScripts()
{
  vtkPythonInterpreter::RunSimpleString(GuardCode);
}

std::string PythonGuard::TakeErrors()
{
  const std::string kind = "RuntimeError: ", guarded = kind + "Script ";
  std::istringstream text(this->Printed);
  this->Printed.clear();
  std::string errors, last;
  for (std::string line; std::getline(text, line); last = line.empty() ? last : line)
  {
    if (line.compare(0, guarded.size(), guarded) == 0)
    {
      errors += (errors.empty() ? "" : "\n") + line.substr(kind.size());
    }
  }
  return errors.empty() ? last : errors;
}

void PythonGuard::Take(vtkObject*, unsigned long, void* self, void* text)
{
  static_cast<PythonGuard*>(self)->Printed += static_cast<const char*>(text);
}

} // namespace vfm
