#include "vtkVolumeFractionMeshAlgorithm.h"

#include "CollectBlocks.h"
#include "CollectivePipeline.h"
#include "ControllerRanks.h"
#include "FieldValues.h"
#include "FilterRuntime.h"
#include "MaterialArrays.h"
#include "MeshOutput.h"
#include "Mesher.h"
#include "MissingLevels.h"
#include "Ranks/WorkTogether.h"
#include "ReadLabelNames.h"
#include "StateOutput.h"

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

using Pipeline = vtkStreamingDemandDrivenPipeline;

// Claimed on the output, so that a later request for ghost layers does not run the filter again.
// The filter marks no cells as ghosts, whatever is asked.
constexpr int GhostLayersClaimed = 4;

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

/// Collective: throws unless all ranks choose the same, neighbours that are known or cells that are shared out.
void AgreeOn(bool knowsNeighbours, vfm::Ranks& ranks)
{
  std::vector<vfm::Index> count{ knowsNeighbours ? 1 : 0 };
  ranks.Sum(count);
  if (count[0] > 0 && count[0] < ranks.Count())
  {
    throw vfm::InputError("Only " + std::to_string(count[0]) + " of " +
      std::to_string(ranks.Count()) + " ranks name their face neighbours. All must, or none.");
  }
}

} // namespace

vtkCxxSetObjectMacro(vtkVolumeFractionMeshAlgorithm, Controller, vtkMultiProcessController);

vtkVolumeFractionMeshAlgorithm::vtkVolumeFractionMeshAlgorithm()
{
  this->SetNumberOfOutputPorts(5);
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

vtkVolumeFractionMeshAlgorithm::~vtkVolumeFractionMeshAlgorithm()
{
  this->SetController(nullptr);
}

void vtkVolumeFractionMeshAlgorithm::SetFaceNeighbours(const int ranks[6])
{
  std::copy_n(ranks, 6, this->FaceNeighbours.begin());
  this->HasFaceNeighbours = true;
  this->Modified();
}

void vtkVolumeFractionMeshAlgorithm::ClearFaceNeighbours()
{
  this->HasFaceNeighbours = false;
  this->Modified();
}

void vtkVolumeFractionMeshAlgorithm::AddRefinementBox(
  double x0, double y0, double z0, double x1, double y1, double z1, double halvings)
{
  this->RefinementBoxes.push_back({ { x0, y0, z0, x1, y1, z1, halvings } });
  this->Modified();
}

void vtkVolumeFractionMeshAlgorithm::ClearRefinementBoxes()
{
  if (!this->RefinementBoxes.empty())
  {
    this->RefinementBoxes.clear();
    this->Modified();
  }
}

int vtkVolumeFractionMeshAlgorithm::GetNumberOfRefinementBoxes()
{
  return static_cast<int>(this->RefinementBoxes.size());
}

void vtkVolumeFractionMeshAlgorithm::SetRefinementOptions(vfm::MesherOptions& options) const
{
  options.Where = static_cast<vfm::Refinement>(this->Refinement);
  options.MaximumLevel = this->MaximumLevel;
  options.FineInterfaces = this->FineInterfaces;
  options.FineLayers = this->FineLayers;
  options.ThinCells = this->ThinCells;
  options.CurvaturePerCell = this->CurvaturePerCell;
  options.RefineFlippedCells = this->RefineFlippedCells;
  options.InterfaceLayers = this->InterfaceLayers;
  options.RefinementArray = this->GetNamedRefinementArray();
  for (const std::array<double, 7>& b : this->RefinementBoxes)
  {
    options.RefinementBoxes.push_back({ { { b[0], b[1], b[2] } }, { { b[3], b[4], b[5] } }, b[6] });
  }
}

vfm::MesherOptions vtkVolumeFractionMeshAlgorithm::GetOptions() const
{
  vfm::MesherOptions options;
  options.IsoValue = this->IsoValue;
  options.MeshVoid = this->MeshVoid;
  options.StairStep = this->StairStep;
  options.Method = static_cast<vfm::Smoothing>(this->Smoothing);
  options.Edges = static_cast<vfm::SharpEdges>(this->SharpEdges);
  options.TargetScaledJacobian = this->TargetScaledJacobian;
  options.ConserveVolume = this->ConserveVolume;
  options.ComputeQuality = this->ComputeQuality;
  options.FractionTolerance = this->FractionTolerance;
  options.LabelSmoothing = this->LabelSmoothing;
  options.MinimumRegionCells = this->MinimumRegionCells;
  options.MaximumAspectRatio = this->MaximumAspectRatio;
  options.Children = static_cast<vfm::ChildRule>(this->ChildFractions);
  this->SetRefinementOptions(options);
  this->SetStateOptions(options);
  this->SpecialiseOptions(options);
  return options;
}

vtkExecutive* vtkVolumeFractionMeshAlgorithm::CreateDefaultExecutive()
{
  return vfm::CollectivePipeline::Make([this] { return this->Controller; });
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
  const char* const kind = port == 0 ? "vtkUnstructuredGrid"
    : port == 4                      ? "vtkTable"
                                     : "vtkPolyData";
  info->Set(vtkDataObject::DATA_TYPE_NAME(), kind);
  return 1;
}

int vtkVolumeFractionMeshAlgorithm::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const auto levels = Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS();
  for (int port = 0; port < this->GetNumberOfOutputPorts(); ++port)
  {
    vtkInformation* info = outputVector->GetInformationObject(port);
    info->Set(levels, std::max(info->Get(levels), GhostLayersClaimed));
  }
  vtkInformation* input = inputVector[0]->GetInformationObject(0);
  input->Set(levels, 0);
  vtkMultiProcessController* controller = this->Controller;
  input->Set(Pipeline::UPDATE_PIECE_NUMBER(), controller ? controller->GetLocalProcessId() : 0);
  input->Set(
    Pipeline::UPDATE_NUMBER_OF_PIECES(), controller ? controller->GetNumberOfProcesses() : 1);
  return 1;
}

int vtkVolumeFractionMeshAlgorithm::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
  const vfm::MeshOutputs outputs{ vtkUnstructuredGrid::GetData(outputVector, 0),
    vtkPolyData::GetData(outputVector, 1), vtkPolyData::GetData(outputVector, 2),
    vtkPolyData::GetData(outputVector, 3), vtkTable::GetData(outputVector, 4) };
  if ((!this->Controller || this->Controller->GetNumberOfProcesses() == 1) &&
    outputVector->GetInformationObject(0)->Get(Pipeline::UPDATE_PIECE_NUMBER()) > 0)
  {
    return 1; // the whole mesh is piece 0
  }
  vfm::FilterRuntime::Execute(this, this->Controller, outputVector,
    [&](vfm::MessageRanks& ranks) { this->Run(input, ranks, outputs); });
  return 1;
}

/// On the first rank, unless the text is empty.
void vtkVolumeFractionMeshAlgorithm::Warn(const std::string& text, const vfm::Ranks& ranks) const
{
  if (ranks.Rank() == 0 && !text.empty())
  {
    vtkWarningMacro(<< text);
  }
}

/// Collective.
vfm::InputLevels vtkVolumeFractionMeshAlgorithm::FindLevels(
  vtkDataObject* input, const vfm::ArraysToRead& arrays, vfm::Ranks& ranks) const
{
  AgreeOn(this->HasFaceNeighbours, ranks);
  vfm::CollectedBlocks collected = vfm::CollectAllBlocks(input, arrays, ranks);
  return this->HasFaceNeighbours
    ? vfm::FindNeighbourLevels(std::move(collected), this->FaceNeighbours, ranks)
    : vfm::FindInputLevels(std::move(collected), ranks);
}

void vtkVolumeFractionMeshAlgorithm::Run(
  vtkDataObject* data, vfm::MessageRanks& ranks, const vfm::MeshOutputs& outputs)
{
  this->Warn(vfm::DescribeMissingLevels(data, ranks), ranks);
  const vfm::MaterialArrays materials = this->FindMaterials(data, ranks);
  const int threads = vfm::ChooseThreads(this->NumberOfThreads, ranks.Count());
  vfm::FilterRuntime runtime(this, threads, &ranks);
  runtime.Progress(0.0, "Reading input");
  vfm::MesherInput input;
  input.Arrays.Fractions = vfm::NamesOf(materials.Fractions);
  input.Arrays.Labels = materials.Labels.Name;
  input.Arrays.Names =
    vfm::ShareLabelNames(materials.HasLabels() ? this->LabelNamesFile : "", ranks);
  input.Arrays.State = this->ChooseState(data, ranks);
  input.Levels = this->FindLevels(data, this->ListArrays(materials, input.Arrays.State), ranks);
  input.StaysInPlace = this->HasFaceNeighbours;
  input.Warn = [&](const std::string& text) { this->Warn(text, ranks); };
  vfm::MesherResult result = vfm::RunMesher(input, this->GetOptions(), runtime);
  LogStages(result.Report);
  vfm::WorkTogether(ranks,
    [&]
    {
      vfm::SetMeshOutput(result.TheMesh, outputs);
      vfm::AddFields(result.Fields, outputs.Mesh->GetFieldData());
      vfm::SetStateOutput(result.State, outputs.Mesh);
      if (ranks.Rank() == 0) // views show the rows of all ranks
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
  os << indent << "FractionTolerance: " << this->FractionTolerance << "\n";
  os << indent << "LabelSmoothing: " << this->LabelSmoothing << "\n";
  os << indent << "LabelNamesFile: " << this->LabelNamesFile << "\n";
  os << indent << "MinimumRegionCells: " << this->MinimumRegionCells << "\n";
  os << indent << "Refinement: " << this->Refinement << "\n";
  os << indent << "MaximumLevel: " << this->MaximumLevel << "\n";
  os << indent << "FineInterfaces: " << this->FineInterfaces << "\n";
  os << indent << "FineLayers: " << this->FineLayers << "\n";
  os << indent << "MaximumAspectRatio: " << this->MaximumAspectRatio << "\n";
  os << indent << "ChildFractions: " << this->ChildFractions << "\n";
  os << indent << "ThinCells: " << this->ThinCells << "\n";
  os << indent << "CurvaturePerCell: " << this->CurvaturePerCell << "\n";
  os << indent << "RefineFlippedCells: " << this->RefineFlippedCells << "\n";
  os << indent << "InterfaceLayers: " << this->InterfaceLayers << "\n";
  os << indent << "RefinementBoxes:" << (this->RefinementBoxes.empty() ? " none" : "") << "\n";
  for (const std::array<double, 7>& box : this->RefinementBoxes)
  {
    os << indent.GetNextIndent();
    for (double number : box)
    {
      os << " " << number;
    }
    os << "\n";
  }
  os << indent << "IsoValue: " << this->IsoValue << "\n";
  os << indent << "MeshVoid: " << this->MeshVoid << "\n";
  os << indent << "StairStep: " << this->StairStep << "\n";
  os << indent << "Smoothing: " << this->Smoothing << "\n";
  os << indent << "SharpEdges: " << this->SharpEdges << "\n";
  os << indent << "TargetScaledJacobian: " << this->TargetScaledJacobian << "\n";
  os << indent << "ConserveVolume: " << this->ConserveVolume << "\n";
  os << indent << "ComputeQuality: " << this->ComputeQuality << "\n";
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
  os << indent << "FaceNeighbours:";
  for (std::size_t f = 0; this->HasFaceNeighbours && f < this->FaceNeighbours.size(); ++f)
  {
    os << " " << this->FaceNeighbours[f];
  }
  os << "\n";
  os << indent << "Controller: " << this->Controller << "\n";
}
