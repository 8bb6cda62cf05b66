/**
 * ScriptPipeline: runs a Catalyst script of version 2 and distinguishes failures from steps that
 * the script does not request. ParaView's vtkCPPythonScriptV2Pipeline returns 0 in both cases.
 */
#pragma once

#include "vtkCPPythonPipeline.h"
#include "vtkCPPythonScriptV2Helper.h"
#include "vtkNew.h"

#include <string>

namespace vfm
{

/// Catalyst pipeline of one script.
class ScriptPipeline : public vtkCPPythonPipeline
{
public:
  static ScriptPipeline* New();
  vtkTypeMacro(ScriptPipeline, vtkCPPythonPipeline);

  /// Loads the file without running it; returns false if that fails.
  bool Open(const std::string& path);

  /// Runs the script at the first call, and enters its requests into the description. Returns false
  /// if it fails.
  bool RequestFields(vtkCPDataDescription* description);

  /// Functions that vtkCPProcessor calls. They return 1 if the script requests the step, if it has
  /// worked, or if it has ended.
  int RequestDataDescription(vtkCPDataDescription* description) override;
  int CoProcess(vtkCPDataDescription* description) override;
  int Finalize() override;

private:
  vtkNew<vtkCPPythonScriptV2Helper> Script;
  bool Initialized = false;
};

} // namespace vfm
