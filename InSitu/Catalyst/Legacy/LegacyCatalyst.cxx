/**
 * LegacyCatalyst: runs legacy Catalyst, ParaView's own library.
 */
#include "CatalystRun.h"
#include "HostImages.h"
#include "PythonGuard.h"
#include "ScriptPipeline.h"

#include "vtkCPDataDescription.h"
#include "vtkCPInputDataDescription.h"
#include "vtkCPProcessor.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkMPI.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"

namespace vfm
{
namespace
{

constexpr const char* InputName = "input";

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

class LegacyCatalyst : public CatalystRun
{
public:
  LegacyCatalyst(MPI_Comm communicator, const std::vector<std::string>& scripts);
  ~LegacyCatalyst() override;
  bool Process(
    const HostGrid& grid, const HostStep& step, const std::vector<HostNumber>& numbers) override;

private:
  template <class Work>
  void RunPython(const Work& work, const std::string& otherwise);
  void AddScript(const std::string& path);
  bool IsRequested(vtkCPDataDescription* description);

  bool IsStarted = false;
  PythonGuard Python;
  vtkNew<vtkCPProcessor> Processor;
  std::vector<vtkSmartPointer<ScriptPipeline>> Scripts;
};

LegacyCatalyst::LegacyCatalyst(MPI_Comm communicator, const std::vector<std::string>& scripts) :
  CatalystRun(communicator)
{
  vtkMPICommunicatorOpaqueComm handle(&this->Communicator);
  this->IsStarted = !HasStarted && this->Processor->Initialize(handle);
  if (!this->IsStarted)
  {
    this->RejectStart();
    return;
  }
  HasStarted = true;
  for (const std::string& path : scripts)
  {
    this->AddScript(path);
  }
  this->Python.GuardScripts();
}

LegacyCatalyst::~LegacyCatalyst()
{
  for (const vtkSmartPointer<ScriptPipeline>& script : this->Scripts)
  {
    script->Finalize(); // scripts need the communicator, which the processor removes
  }
  this->Scripts.clear();
  this->Processor->RemoveAllPipelines();
  if (this->IsStarted)
  {
    this->Processor->Finalize();
  }
}

/// Calls work() and throws the errors that Python printed if it returns false.
/// @param otherwise  message if Python printed nothing
template <class Work>
void LegacyCatalyst::RunPython(const Work& work, const std::string& otherwise)
{
  const bool worked = work();
  const std::string printed = this->Python.TakeErrors();
  if (!worked)
  {
    throw InputError(printed.empty() ? otherwise : printed);
  }
}

void LegacyCatalyst::AddScript(const std::string& path)
{
  if (!this->CanRead(path))
  {
    return;
  }
  if (vtkCPPythonPipeline::DetectScriptVersion(path.c_str()) == 1)
  {
    AddLine(this->LeftOut, "Script " + path + " is a Catalyst script of version 1; 2 is required.");
    return;
  }
  vtkNew<ScriptPipeline> pipeline;
  const auto open = [&] {
    this->RunPython([&] { return pipeline->Open(path); }, "Script " + path + " cannot be loaded.");
  };
  if (this->Agree(open, this->LeftOut))
  {
    this->Processor->AddPipeline(pipeline);
    this->Scripts.push_back(pipeline);
  }
}

/// Returns whether any script requests the step. Scripts that fail to answer are excluded.
bool LegacyCatalyst::IsRequested(vtkCPDataDescription* description)
{
  std::vector<vtkSmartPointer<ScriptPipeline>> kept;
  for (const vtkSmartPointer<ScriptPipeline>& script : this->Scripts)
  {
    const auto ask = [&]
    {
      this->RunPython(
        [&] { return script->RequestFields(description); }, "A Catalyst script cannot be run.");
    };
    if (this->Agree(ask, this->LeftOut))
    {
      kept.push_back(script);
    }
    else
    {
      this->Processor->RemovePipeline(script);
    }
  }
  this->Scripts = kept;
  return !kept.empty() && this->Group.Any(description->GetIfGridIsNecessary(InputName));
}

bool LegacyCatalyst::Process(
  const HostGrid& grid, const HostStep& step, const std::vector<HostNumber>& numbers)
{
  vtkNew<vtkCPDataDescription> description;
  description->AddInput(InputName);
  description->SetTimeData(step.Time, step.Number);
  description->SetForceOutput(step.IsLast);
  if (!this->IsRequested(description))
  {
    return true;
  }
  vtkSmartPointer<vtkMultiBlockDataSet> blocks;
  const auto make = [&]
  {
    blocks = MakeAllBlocks(grid, this->Group);
    AddNumbers(numbers, blocks);
    description->GetInputDescriptionByName(InputName)->SetGrid(blocks);
  };
  if (!this->Agree(make, this->Failed))
  {
    return false;
  }
  ++this->StepsMade;
  const auto run = [&]
  {
    this->RunPython(
      [&] { return this->Processor->CoProcess(description); }, "A Catalyst script failed.");
  };
  const bool done = this->Agree(run, this->Failed);
  blocks->Initialize(); // scripts keep the object, but must not keep the simulation's memory
  return done;
}

} // namespace

std::unique_ptr<CatalystRun> StartCatalyst(
  MPI_Comm communicator, const std::vector<std::string>& scripts)
{
  return std::make_unique<LegacyCatalyst>(communicator, scripts);
}

} // namespace vfm
