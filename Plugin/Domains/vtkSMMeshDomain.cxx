#include "vtkSMMeshDomain.h"

#include "vtkCommunicator.h"
#include "vtkDataObject.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPVDataInformation.h"
#include "vtkPVDataSetAttributesInformation.h"
#include "vtkProcessModule.h"
#include "vtkSMInputProperty.h"
#include "vtkSMSourceProxy.h"

vtkStandardNewMacro(vtkSMMeshDomain);

namespace
{

bool HasArray(vtkPVDataInformation* info, int association, const char* name)
{
  vtkPVDataSetAttributesInformation* attributes = info->GetAttributeInformation(association);
  return attributes && attributes->GetArrayInformation(name);
}

bool IsMesh(vtkPVDataInformation* info)
{
  return (HasArray(info, vtkDataObject::CELL, "MaterialId") &&
           HasArray(info, vtkDataObject::CELL, "GlobalCellIds") &&
           HasArray(info, vtkDataObject::POINT, "GlobalPointIds")) ||
    HasArray(info, vtkDataObject::FIELD, "MeshError");
}

bool OnAnyRank(bool here)
{
  vtkMultiProcessController* ranks = vtkMultiProcessController::GetGlobalController();
  if (!ranks || !vtkProcessModule::GetSymmetricMPIMode())
  {
    return here;
  }
  const int mine = here ? 1 : 0;
  int any = 0;
  ranks->AllReduce(&mine, &any, 1, vtkCommunicator::MAX_OP);
  return any != 0;
}

} // namespace

int vtkSMMeshDomain::IsInDomain(vtkSMProperty* property)
{
  auto* input = vtkSMInputProperty::SafeDownCast(property);
  auto* source = input && input->GetNumberOfUncheckedProxies() == 1
    ? vtkSMSourceProxy::SafeDownCast(input->GetUncheckedProxy(0))
    : nullptr;
  vtkPVDataInformation* info =
    source ? source->GetDataInformation(input->GetUncheckedOutputPortForConnection(0)) : nullptr;
  return OnAnyRank(info && IsMesh(info)) ? vtkSMDomain::IN_DOMAIN : vtkSMDomain::NOT_IN_DOMAIN;
}
