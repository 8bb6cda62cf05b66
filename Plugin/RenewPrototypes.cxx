#include "RenewPrototypes.h"

#include "vtkProcessModule.h"
#include "vtkSMProxy.h"
#include "vtkSMProxyManager.h"
#include "vtkSMSessionProxyManager.h"

namespace vfm
{

void RenewPrototypes()
{
  constexpr const char* Group = "writers_prototypes"; // name in ParaView
  constexpr const char* Name = "ExodusAndSetsWriter";
  if (vtkProcessModule::GetProcessType() != vtkProcessModule::PROCESS_CLIENT)
  {
    return;
  }
  vtkSMSessionProxyManager* manager =
    vtkSMProxyManager::GetProxyManager()->GetActiveSessionProxyManager();
  if (vtkSMProxy* prototype = manager ? manager->GetProxy(Group, Name) : nullptr)
  {
    manager->UnRegisterProxy(Group, Name, prototype);
  }
}

} // namespace vfm
