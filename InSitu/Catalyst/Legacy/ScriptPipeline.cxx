#include "ScriptPipeline.h"

#include "vtkCPDataDescription.h"
#include "vtkObjectFactory.h"

namespace vfm
{

vtkStandardNewMacro(ScriptPipeline);

bool ScriptPipeline::Open(const std::string& path)
{
  return this->Script->PrepareFromScript(path);
}

bool ScriptPipeline::RequestFields(vtkCPDataDescription* description)
{
  if (!this->Initialized)
  {
    this->Initialized =
      this->Script->Import(description) && this->Script->CatalystInitialize(description);
  }
  // A script that is not initialized must not be called: ParaView would follow a null pointer.
  return this->Initialized && this->Script->RequestDataDescription(description);
}

int ScriptPipeline::RequestDataDescription(vtkCPDataDescription* description)
{
  return this->RequestFields(description) && description->GetIfAnyGridNecessary();
}

int ScriptPipeline::CoProcess(vtkCPDataDescription* description)
{
  return this->Script->CatalystExecute(description);
}

int ScriptPipeline::Finalize()
{
  return !this->Initialized || this->Script->CatalystFinalize();
}

} // namespace vfm
