#include "vtkVolumeFractionMeshAlgorithm.h"

#include "CollectBlocks.h"
#include "ControllerRanks.h"
#include "FieldValues.h"
#include "FilterRuntime.h"
#include "LabelNameFields.h"
#include "Labels/ReadLabelNames.h"
#include "MaterialArrays.h"
#include "MeshOutput.h"
#include "Mesher.h"
#include "MissingLevels.h"
#include "Ranks/WorkTogether.h"
#include "StateOutput.h"
#include "SurfaceFields.h"

#include "vtkCompositeDataSet.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkLogger.h"
#include "vtkMultiProcessController.h"
#include "vtkPolyData.h"
#include "vtkRectilinearGrid.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace
{

/// Collective. Returns the names of labels of a table, or of the input if there is no table.
/// @param table  path of a file; empty: none
/// @param warn  receives a note about the table
vfm::LabelNames ChooseLabelNames(const std::string& table, vtkDataObject* input, vfm::Ranks& ranks,
  const std::function<void(const std::string&)>& warn)
{
  return table.empty() ? vfm::UniteLabelNames(vfm::FindLabelNames(input->GetFieldData()), ranks)
                       : vfm::ShareLabelNames(table, ranks, warn);
}

using Pipeline = vtkStreamingDemandDrivenPipeline;

void LogStages(const vfm::MeshReport& report)
{
  for (const vfm::MeshReport::Stage& stage : report.Stages)
  {
    vtkLogF(TRACE, "%s: %.3f s", stage.Name, stage.Seconds);
  }
}

void LogTraffic(const vfm::MessageRanks& ranks)
{
  const vfm::MessageRanks::Traffic& sent = ranks.Sent();
  vtkLogF(TRACE,
    "rank %d sent %lld messages of %lld bytes in %lld exchanges; %lld reductions, %lld bytes in "
    "%lld gathers",
    ranks.Rank(), static_cast<long long>(sent.Messages), static_cast<long long>(sent.MessageBytes),
    static_cast<long long>(sent.Exchanges), static_cast<long long>(sent.Reductions),
    static_cast<long long>(sent.GatheredBytes), static_cast<long long>(sent.Gathers));
}

} // namespace

vtkVolumeFractionMeshAlgorithm::vtkVolumeFractionMeshAlgorithm(vfm::ElementKind elements)
{
  this->Options->Elements = elements;
  this->SetNumberOfOutputPorts(7);
}

vtkVolumeFractionMeshAlgorithm::~vtkVolumeFractionMeshAlgorithm() = default;

double* vtkVolumeFractionMeshAlgorithm::GetInputSpacing()
{
  std::fill_n(this->InputSpacing, 3, 0.0);
  vtkInformation* info =
    this->GetNumberOfInputConnections(0) > 0 ? this->GetInputInformation(0, 0) : nullptr;
  if (info && info->Has(vtkDataObject::SPACING()))
  {
    info->Get(vtkDataObject::SPACING(), this->InputSpacing);
  }
  return this->InputSpacing;
}

int vtkVolumeFractionMeshAlgorithm::FillInputPortInformation(int, vtkInformation* info)
{
  info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  for (const char* type : { "vtkImageData", "vtkRectilinearGrid", "vtkStructuredGrid",
         "vtkUnstructuredGrid", "vtkCompositeDataSet" })
  {
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), type);
  }
  return 1;
}

int vtkVolumeFractionMeshAlgorithm::FillOutputPortInformation(int port, vtkInformation* info)
{
  const char* const kind = port == 0 || port == 5 ? "vtkUnstructuredGrid"
    : port == 4                                   ? "vtkTable"
                                                  : "vtkPolyData";
  info->Set(vtkDataObject::DATA_TYPE_NAME(), kind);
  return 1;
}

int vtkVolumeFractionMeshAlgorithm::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
  for (int port = 0; port < this->GetNumberOfOutputPorts(); ++port)
  {
    vfm::RemoveSurfaceFields(vtkDataObject::GetData(outputVector, port)->GetFieldData());
  }
  const vfm::MeshOutputs outputs{ vtkUnstructuredGrid::GetData(outputVector, 0),
    vtkPolyData::GetData(outputVector, 1), vtkPolyData::GetData(outputVector, 2),
    vtkPolyData::GetData(outputVector, 3), vtkTable::GetData(outputVector, 4),
    vtkUnstructuredGrid::GetData(outputVector, 5), vtkPolyData::GetData(outputVector, 6) };
  if ((!this->Controller || this->Controller->GetNumberOfProcesses() == 1) &&
    outputVector->GetInformationObject(0)->Get(Pipeline::UPDATE_PIECE_NUMBER()) > 0)
  {
    return 1; // the whole mesh is piece 0
  }
  vfm::FilterRuntime::Execute(this, this->Controller, outputVector,
    [&](vfm::MessageRanks& ranks) { this->Run(input, ranks, outputs); });
  return 1;
}

/// Warns on rank 0, unless the text is empty.
void vtkVolumeFractionMeshAlgorithm::Warn(const std::string& text, const vfm::Ranks& ranks) const
{
  if (ranks.Rank() == 0 && !text.empty())
  {
    vtkWarningMacro(<< text);
  }
}

void vtkVolumeFractionMeshAlgorithm::Run(
  vtkDataObject* data, vfm::MessageRanks& ranks, const vfm::MeshOutputs& outputs)
{
  this->Warn(vfm::DescribeMissingLevels(data, ranks), ranks);
  const vfm::MaterialArrays materials = this->FindMaterials(data, ranks);
  const int threads = vfm::ChooseThreads(this->Options->NumberOfThreads, ranks.Count());
  vfm::FilterRuntime runtime(this, threads, &ranks);
  runtime.Progress(0.0, "Reading input");
  vfm::MesherInput input;
  input.Warn = [&](const std::string& text) { this->Warn(text, ranks); };
  input.Arrays.Fractions = vfm::NamesOf(materials.Fractions);
  input.Arrays.Labels = materials.Labels.Name;
  input.Arrays.AreGuessed = materials.AreGuessed;
  input.Arrays.Names = materials.HasLabels()
    ? ChooseLabelNames(this->Options->LabelNames, data, ranks, input.Warn)
    : vfm::LabelNames();
  input.Arrays.State = this->ChooseState(data, ranks);
  const vfm::ArraysToRead arrays =
    vfm::ListArrays(materials.List(), input.Arrays.State, *this->Options);
  input.Levels = vfm::FindInputLevels(vfm::CollectAllBlocks(data, arrays, ranks), ranks);
  input.Surfaces = vfm::FindSurfaces(data, ranks);
  vfm::MesherResult result = vfm::RunMesher(input, *this->Options, runtime);
  LogStages(result.Report);
  vfm::WorkTogether(ranks,
    [&]
    {
      vfm::SetMeshOutput(result.TheMesh, vfm::JoinBlocks(result.Cohesive), outputs);
      vfm::AddFields(result.Fields, outputs.Mesh->GetFieldData());
      vfm::SetStateOutput(result.State, outputs.Mesh);
      if (result.State.TheParticles)
      {
        vfm::SetParticleOutput(*result.State.TheParticles, result.Fields, outputs.Particles);
      }
      if (ranks.Rank() == 0) // views append the rows of all ranks
      {
        vfm::AddColumns(result.MaterialFields, outputs.Materials);
      }
    });
  LogTraffic(ranks);
}

void vtkVolumeFractionMeshAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  this->PrintArrays(os, indent);
}
