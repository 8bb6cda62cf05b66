#include "WatchMaterials.h"

#include "NameMaterials.h"
#include "vtkPVMaterialsInformation.h"

#include "vtkClientServerInterpreter.h"
#include "vtkClientServerInterpreterInitializer.h"
#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkProcessModule.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMProxyIterator.h"
#include "vtkSMProxyManager.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkWeakPointer.h"

#include <cstring>
#include <utility>

namespace vfm
{
namespace
{

constexpr const char* Arrays[] = { "MaterialId", "MaterialPair" };

vtkObjectBase* NewMaterialsInformation(void*)
{
  return vtkPVMaterialsInformation::New();
}

/// Registers vtkPVMaterialsInformation, which servers create by name.
void AddInformation(vtkClientServerInterpreter* interpreter)
{
  interpreter->AddNewInstanceFunction("vtkPVMaterialsInformation", NewMaterialsInformation);
}

/// Returns whether the server of a proxy has loaded this plugin, and so the information.
bool KnowsMaterials(vtkSMProxy* proxy)
{
  vtkSMSessionProxyManager* manager = proxy->GetSessionProxyManager();
  return manager->GetPrototypeProxy("filters", "VolumeFractionToHex") != nullptr;
}

MaterialNames GatherNames(vtkSMProxy* representation)
{
  vtkSMProxy* input = vtkSMPropertyHelper(representation, "Input").GetAsProxy();
  if (!input || !input->GetObjectsCreated() || !KnowsMaterials(input))
  {
    return {};
  }
  vtkNew<vtkPVMaterialsInformation> information;
  input->GatherInformation(information);
  return information->GetNames();
}

/// Observes representations of data and colour maps of material ids: events when ParaView registers
/// or updates one.
class Watch : public vtkCommand
{
public:
  static Watch* New() { return new Watch; }

  void Execute(vtkObject* caller, unsigned long event, void* data) override
  {
    if (event == vtkCommand::UpdateDataEvent)
    {
      this->NameIn(vtkSMProxy::SafeDownCast(caller));
      return;
    }
    const auto* registered = static_cast<vtkSMProxyManager::RegisteredProxyInformation*>(data);
    if (registered->Type != vtkSMProxyManager::RegisteredProxyInformation::PROXY)
    {
      return;
    }
    if (!std::strcmp(registered->GroupName, "representations"))
    {
      this->WatchRepresentation(registered->Proxy);
    }
    else if (!std::strcmp(registered->GroupName, "lookup_tables"))
    {
      this->NameInAll(registered->Proxy->GetSessionProxyManager());
    }
  }

private:
  void WatchRepresentation(vtkSMProxy* representation)
  {
    if (representation->GetProperty("Input") && representation->GetProperty("ColorArrayName") &&
      !representation->HasObserver(vtkCommand::UpdateDataEvent, this))
    {
      representation->AddObserver(vtkCommand::UpdateDataEvent, this);
      this->NameIn(representation);
    }
  }

  void NameInAll(vtkSMSessionProxyManager* manager)
  {
    vtkNew<vtkSMProxyIterator> all;
    all->SetSessionProxyManager(manager);
    for (all->Begin("representations"); !all->IsAtEnd(); all->Next())
    {
      if (all->GetProxy()->HasObserver(vtkCommand::UpdateDataEvent, this))
      {
        this->NameIn(all->GetProxy());
      }
    }
  }

  /// Writes names into the colour maps of a representation, both shared and separate ones.
  void NameIn(vtkSMProxy* representation)
  {
    vtkSMSessionProxyManager* manager = representation->GetSessionProxyManager();
    const std::string own = std::string("Separate_") + representation->GetGlobalIDAsString() + "_";
    MaterialNames names;
    for (const std::string array : Arrays)
    {
      for (const std::string& name : { array, own + array })
      {
        vtkSMProxy* colourMap =
          manager->GetProxy("lookup_tables", (name + ".PVLookupTable").c_str());
        if (!colourMap)
        {
          continue;
        }
        if (names.empty())
        {
          names = GatherNames(representation);
        }
        if (array == "MaterialPair")
        {
          this->NamePairs(colourMap, names);
        }
        else
        {
          NameMaterials(colourMap, names, this->GivenTo(colourMap));
        }
      }
    }
  }

  /// Names pairs by their larger id, which is the material on outer surfaces.
  void NamePairs(vtkSMProxy* colourMap, MaterialNames names)
  {
    if (!names.empty())
    {
      names.emplace(0, "Void");
    }
    if (NameMaterials(colourMap, names, this->GivenTo(colourMap)))
    {
      vtkSMPropertyHelper(colourMap, "VectorMode").Set("Component");
      vtkSMPropertyHelper(colourMap, "VectorComponent").Set(1);
      colourMap->UpdateVTKObjects();
    }
  }

  MaterialNames& GivenTo(vtkSMProxy* colourMap)
  {
    Record& record = this->Given[colourMap];
    if (record.first != colourMap) // a new map at the address of a deleted one
    {
      record = Record(colourMap, MaterialNames());
    }
    return record.second;
  }

  using Record = std::pair<vtkWeakPointer<vtkSMProxy>, MaterialNames>;
  std::map<vtkSMProxy*, Record> Given;
};

} // namespace

void WatchMaterials()
{
  vtkClientServerInterpreterInitializer::GetInitializer()->RegisterCallback(AddInformation);
  const vtkProcessModule::ProcessTypes process = vtkProcessModule::GetProcessType();
  if (process == vtkProcessModule::PROCESS_CLIENT || process == vtkProcessModule::PROCESS_BATCH)
  {
    vtkNew<Watch> watch;
    vtkSMProxyManager::GetProxyManager()->AddObserver(vtkCommand::RegisterEvent, watch);
  }
}

} // namespace vfm
