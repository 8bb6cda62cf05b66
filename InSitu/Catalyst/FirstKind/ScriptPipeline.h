/**
 * ScriptPipeline: a Catalyst script of version 2 that tells failures apart from steps it does not want. ParaView's own
 * vtkCPPythonScriptV2Pipeline answers 0 to both.
 */
#pragma once

#include "vtkCPPythonPipeline.h"
#include "vtkCPPythonScriptV2Helper.h"
#include "vtkNew.h"

#include <string>

namespace vfm
{

class ScriptPipeline : public vtkCPPythonPipeline
{
public:
  static ScriptPipeline* New();
  vtkTypeMacro(ScriptPipeline, vtkCPPythonPipeline);

  /// Makes the file known to Python, without running it. False when that fails.
  bool Open(const std::string& path);

  /// Whether the script could be asked; runs it first. What it wants is in the description.
  bool RequestFields(vtkCPDataDescription* description);

  /// vtkCPProcessor's calls. 1: it wants the step; it worked; it ended.
  int RequestDataDescription(vtkCPDataDescription* description) override;
  int CoProcess(vtkCPDataDescription* description) override;
  int Finalize() override;

private:
  vtkNew<vtkCPPythonScriptV2Helper> Script;
  bool Initialized = false;
};

} // namespace vfm
