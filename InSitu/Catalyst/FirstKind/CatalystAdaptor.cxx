#include "CatalystAdaptor.h"

#include "AgreeOnErrors.h"
#include "AllBlocks.h"
#include "ControllerRanks.h"
#include "PythonGuard.h"
#include "ScriptPipeline.h"

#include "vtkCPDataDescription.h"
#include "vtkCPInputDataDescription.h"
#include "vtkCPProcessor.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkMPI.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"

namespace vfm
{
namespace
{

constexpr const char* InputName = "input";

/// Of the communicator that Catalyst was given.
vtkMultiProcessController* Controller()
{
  return vtkMultiProcessController::GetGlobalController();
}

void AddNumbers(const std::vector<HostNumber>& numbers, vtkDataObject* data)
{
  for (const HostNumber& number : numbers)
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(number.Name.c_str());
    array->InsertNextValue(number.Value);
    data->GetFieldData()->AddArray(array);
  }
}

} // namespace

class CatalystAdaptor::Internals : public Failures
{
public:
  Internals(MPI_Comm communicator, const std::vector<std::string>& scripts);
  ~Internals();
  bool Process(const HostGrid& grid, vtkCPDataDescription* description,
    const std::vector<HostNumber>& numbers);

  int StepsMade = 0;

private:
  template <class Work>
  void RunPython(const Work& work, const std::string& otherwise);
  void AddScript(const std::string& path);
  bool IsWanted(vtkCPDataDescription* description);

  bool Started = false;
  PythonGuard Python;
  MPI_Comm Communicator = MPI_COMM_NULL;
  vtkNew<vtkCPProcessor> Processor;
  std::vector<vtkSmartPointer<ScriptPipeline>> Scripts;
};

CatalystAdaptor::Internals::Internals(
  MPI_Comm communicator, const std::vector<std::string>& scripts)
{
  static bool started = false; // ParaView cannot start again after it has ended
  MPI_Comm_dup(communicator, &this->Communicator);
  vtkMPICommunicatorOpaqueComm handle(&this->Communicator);
  this->Started = !started && this->Processor->Initialize(handle);
  if (!this->Started)
  {
    this->LeftOut = "Catalyst cannot start: it runs or has run before in this process.";
    return;
  }
  started = true;
  for (const std::string& path : scripts)
  {
    this->AddScript(path);
  }
  this->Python.GuardScripts();
}

CatalystAdaptor::Internals::~Internals()
{
  for (const vtkSmartPointer<ScriptPipeline>& script : this->Scripts)
  {
    script->Finalize(); // before the processor takes the communicator away
  }
  this->Scripts.clear();
  this->Processor->RemoveAllPipelines();
  if (this->Started)
  {
    this->Processor->Finalize();
  }
  MPI_Comm_free(&this->Communicator);
}

/// Throws what Python printed when the work is false; otherwise: what is told when it printed nothing.
template <class Work>
void CatalystAdaptor::Internals::RunPython(const Work& work, const std::string& otherwise)
{
  const bool worked = work();
  const std::string printed = this->Python.TakeErrors();
  if (!worked)
  {
    throw InputError(printed.empty() ? otherwise : printed);
  }
}

void CatalystAdaptor::Internals::AddScript(const std::string& path)
{
  ControllerRanks ranks(Controller());
  if (!CanRead(path, ranks, this->LeftOut))
  {
    return;
  }
  if (vtkCPPythonPipeline::DetectScriptVersion(path.c_str()) == 1)
  {
    AddLine(this->LeftOut, "Script " + path + " is of Catalyst's version 1; 2 is needed.");
    return;
  }
  vtkNew<ScriptPipeline> pipeline;
  const auto open = [&] {
    this->RunPython([&] { return pipeline->Open(path); }, "Script " + path + " cannot be loaded.");
  };
  if (Agree(ranks, open, this->LeftOut))
  {
    this->Processor->AddPipeline(pipeline);
    this->Scripts.push_back(pipeline);
  }
}

/// Whether any script wants the step; those that cannot be asked are left out from now on.
bool CatalystAdaptor::Internals::IsWanted(vtkCPDataDescription* description)
{
  ControllerRanks ranks(Controller());
  std::vector<vtkSmartPointer<ScriptPipeline>> kept;
  for (const vtkSmartPointer<ScriptPipeline>& script : this->Scripts)
  {
    const auto ask = [&] {
      this->RunPython([&] { return script->Ask(description); }, "A Catalyst script cannot be run.");
    };
    if (Agree(ranks, ask, this->LeftOut))
    {
      kept.push_back(script);
    }
    else
    {
      this->Processor->RemovePipeline(script);
    }
  }
  this->Scripts = kept;
  return !kept.empty() && ranks.Any(description->GetIfGridIsNecessary(InputName));
}

bool CatalystAdaptor::Internals::Process(
  const HostGrid& grid, vtkCPDataDescription* description, const std::vector<HostNumber>& numbers)
{
  if (!this->IsWanted(description))
  {
    return true;
  }
  ControllerRanks ranks(Controller());
  vtkSmartPointer<vtkMultiBlockDataSet> blocks;
  const auto make = [&]
  {
    blocks = MakeAllBlocks(grid, ranks);
    AddNumbers(numbers, blocks);
    description->GetInputDescriptionByName(InputName)->SetGrid(blocks);
  };
  if (!Agree(ranks, make, this->Failed))
  {
    return false;
  }
  ++this->StepsMade;
  const auto run = [&]
  {
    this->RunPython(
      [&] { return this->Processor->CoProcess(description); }, "A Catalyst script failed.");
  };
  const bool done = Agree(ranks, run, this->Failed);
  blocks->Initialize(); // the scripts keep it, but not the host's memory
  return done;
}

CatalystAdaptor::CatalystAdaptor(MPI_Comm communicator, const std::vector<std::string>& scripts) :
  Self(std::make_unique<Internals>(communicator, scripts))
{
}

CatalystAdaptor::~CatalystAdaptor() = default;

bool CatalystAdaptor::Process(
  const HostGrid& grid, double time, int step, const std::vector<HostNumber>& numbers, bool last)
{
  vtkNew<vtkCPDataDescription> description;
  description->AddInput(InputName);
  description->SetTimeData(time, step);
  description->SetForceOutput(last);
  this->Self->Failed.clear();
  const bool processed = this->Self->Process(grid, description, numbers);
  return processed && this->GetError().empty();
}

const std::string& CatalystAdaptor::GetError() const
{
  return this->Self->Tell();
}

int CatalystAdaptor::GetNumberOfStepsMade() const
{
  return this->Self->StepsMade;
}

} // namespace vfm
