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

/// Servers make the information by its name.
void AddInformation(vtkClientServerInterpreter* interpreter)
{
  interpreter->AddNewInstanceFunction("vtkPVMaterialsInformation", NewMaterialsInformation);
}

/// Whether the server that has the proxy has this plugin too, and so the information.
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

/// The representations of data, and the colour maps of material ids; by the event that ParaView has registered one, or updated it.
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

  /// In the colour maps of an array, that of all representations and that of this one alone, if there are some.
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

  /// By the larger id of a pair, which on outer surfaces is that of the material.
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
    if (record.first != colourMap) // a new one in the memory of one that is gone
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
