#include "vtkVolumeFractionInterfaces.h"

#include "ControllerRanks.h"
#include "FieldValues.h"
#include "FilterRuntime.h"
#include "MeshDataOfGrid.h"
#include "MeshOutput.h"
#include "ModifyMesh.h"
#include "Options/SetOptions.h"
#include "StateOutput.h"

#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

vtkStandardNewMacro(vtkVolumeFractionInterfaces);

vtkVolumeFractionInterfaces::vtkVolumeFractionInterfaces()
{
  this->Options->FirstLayerUnit = vfm::ThicknessUnit::Length;
  this->SetNumberOfOutputPorts(2);
}

void vtkVolumeFractionInterfaces::AddExtensiveArray(const char* name)
{
  if (name && *name)
  {
    this->ExtensiveArrays.emplace_back(name);
    this->Modified();
  }
}

void vtkVolumeFractionInterfaces::ClearExtensiveArrays()
{
  this->ExtensiveArrays.clear();
  this->Modified();
}

int vtkVolumeFractionInterfaces::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vfm::FilterRuntime::Execute(this, this->Controller, outputVector,
    [&](vfm::MessageRanks& ranks)
    {
      this->Run(vtkUnstructuredGrid::GetData(inputVector[0]), ranks,
        vtkUnstructuredGrid::GetData(outputVector, 0),
        vtkUnstructuredGrid::GetData(outputVector, 1));
    });
  return 1;
}

void vtkVolumeFractionInterfaces::Run(vtkUnstructuredGrid* data, vfm::MessageRanks& ranks,
  vtkUnstructuredGrid* mesh, vtkUnstructuredGrid* cohesive)
{
  for (vtkUnstructuredGrid* output : { mesh, cohesive })
  {
    output->GetFieldData()->Initialize(); // VTK passes that of the input
  }
  const int threads = vfm::ChooseThreads(this->Options->NumberOfThreads, ranks.Count());
  vfm::FilterRuntime runtime(this, threads, &ranks);
  vfm::StoredMesh stored;
  vfm::WorkTogether(ranks, [&] { stored = vfm::MeshDataOf(data); });
  vfm::ModifyInput input;
  input.Data = stored.Data;
  input.Extensive = this->ExtensiveArrays;
  input.Warn = [this](const std::string& text) { vtkWarningMacro(<< text); };
  vfm::ModifiedMesh result = vfm::ModifyMesh(std::move(input), *this->Options, runtime);
  vfm::WorkTogether(ranks,
    [&]
    {
      vfm::SetCohesiveOutput(result.TheMesh, vfm::JoinBlocks(result.Cohesive), cohesive);
      vfm::SetElementOutput(result.TheMesh, mesh);
      vfm::AddFields(result.Fields, mesh->GetFieldData());
      vfm::SetStateOutput(result.State, mesh);
      vfm::AddPointArrays(result.PointArrays, mesh);
    });
}

void vtkVolumeFractionInterfaces::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  for (const vfm::Option& option : vfm::GetOptionTable())
  {
    if (option.Group == "Split interfaces" || option.Group == "Layers")
    {
      os << indent << option.Name << ": " << vfm::GetOption(*this->Options, option) << "\n";
    }
  }
  os << indent << "ExtensiveArrays:";
  for (const std::string& name : this->ExtensiveArrays)
  {
    os << " '" << name << "'";
  }
  os << "\n";
}
