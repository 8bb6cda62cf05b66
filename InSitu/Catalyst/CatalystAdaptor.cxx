#include "CatalystAdaptor.h"

#include "Agreement.h"
#include "Base/Runtime.h"
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

#include <fstream>
#include <functional>

namespace vfm
{
namespace
{

constexpr const char* InputName = "input";

void AddLine(std::string& text, const std::string& line)
{
  text += (text.empty() ? "" : "\n") + line;
}

/// The boxes of all ranks as one composite, numbered by rank. Collective.
vtkSmartPointer<vtkMultiBlockDataSet> MakeAllBlocks(const HostGrid& grid, MPI_Comm communicator)
{
  const unsigned int mine = static_cast<unsigned int>(grid.Boxes.size());
  unsigned int end = 0, total = 0;
  MPI_Scan(&mine, &end, 1, MPI_UNSIGNED, MPI_SUM, communicator);
  MPI_Allreduce(&mine, &total, 1, MPI_UNSIGNED, MPI_SUM, communicator);
  return MakeBlocks(grid, end - mine, total);
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

class CatalystAdaptor::Internals
{
public:
  Internals(MPI_Comm communicator, const std::vector<std::string>& scripts);
  ~Internals();
  bool Process(const HostGrid& grid, vtkCPDataDescription* description,
    const std::vector<HostNumber>& numbers);

  std::string LeftOut, Failed, Error;
  int StepsMade = 0;

private:
  bool Agree(const std::function<void()>& work, std::string& errors);
  bool Agree(bool worked, const std::string& otherwise, std::string& errors);
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

/// Collective: does the work; adds what failed on any rank to the errors. Whether it went well everywhere.
bool CatalystAdaptor::Internals::Agree(const std::function<void()>& work, std::string& errors)
{
  ControllerRanks ranks(vtkMultiProcessController::GetGlobalController());
  try
  {
    WorkTogether(ranks, work);
    return true;
  }
  catch (const InputError& error)
  {
    AddLine(errors, error.what());
    return false;
  }
}

/// The same for what was done in Python; otherwise: what is told when Python printed nothing.
bool CatalystAdaptor::Internals::Agree(
  bool worked, const std::string& otherwise, std::string& errors)
{
  const std::string printed = this->Python.TakeErrors();
  const auto check = [&]
  {
    if (!worked)
    {
      throw InputError(printed.empty() ? otherwise : printed);
    }
  };
  return this->Agree(check, errors);
}

void CatalystAdaptor::Internals::AddScript(const std::string& path)
{
  const auto read = [&]
  {
    if (!std::ifstream(path).good())
    {
      throw InputError("Script " + path + " cannot be read.");
    }
  };
  if (!this->Agree(read, this->LeftOut))
  {
    return;
  }
  if (vtkCPPythonPipeline::DetectScriptVersion(path.c_str()) == 1)
  {
    AddLine(this->LeftOut, "Script " + path + " is of Catalyst's version 1; 2 is needed.");
    return;
  }
  vtkNew<ScriptPipeline> pipeline;
  const bool opened = pipeline->Open(path);
  if (this->Agree(opened, "Script " + path + " cannot be loaded.", this->LeftOut))
  {
    this->Processor->AddPipeline(pipeline);
    this->Scripts.push_back(pipeline);
  }
}

/// Whether any script wants the step; those that cannot be asked are left out from now on.
bool CatalystAdaptor::Internals::IsWanted(vtkCPDataDescription* description)
{
  std::vector<vtkSmartPointer<ScriptPipeline>> kept;
  for (const vtkSmartPointer<ScriptPipeline>& script : this->Scripts)
  {
    const bool asked = script->Ask(description);
    if (this->Agree(asked, "A Catalyst script cannot be run.", this->LeftOut))
    {
      kept.push_back(script);
    }
    else
    {
      this->Processor->RemovePipeline(script);
    }
  }
  this->Scripts = kept;
  ControllerRanks ranks(vtkMultiProcessController::GetGlobalController());
  return !kept.empty() && ranks.Any(description->GetIfGridIsNecessary(InputName));
}

bool CatalystAdaptor::Internals::Process(
  const HostGrid& grid, vtkCPDataDescription* description, const std::vector<HostNumber>& numbers)
{
  if (!this->IsWanted(description))
  {
    return true;
  }
  if (!this->Agree([&] { CheckHostGrid(grid); }, this->Failed))
  {
    return false;
  }
  const auto blocks = MakeAllBlocks(grid, this->Communicator);
  AddNumbers(numbers, blocks);
  description->GetInputDescriptionByName(InputName)->SetGrid(blocks);
  ++this->StepsMade;
  const bool done = this->Processor->CoProcess(description);
  blocks->Initialize(); // the scripts keep it, but not the host's memory
  return this->Agree(done, "A Catalyst script failed.", this->Failed);
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
  this->Self->Error = this->Self->LeftOut;
  if (!this->Self->Failed.empty())
  {
    AddLine(this->Self->Error, this->Self->Failed);
  }
  return this->Self->Error;
}

int CatalystAdaptor::GetNumberOfStepsMade() const
{
  return this->Self->StepsMade;
}

} // namespace vfm
