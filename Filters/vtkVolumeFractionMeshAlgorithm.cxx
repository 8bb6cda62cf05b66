#include "vtkVolumeFractionMeshAlgorithm.h"

#include "Base/Agreement.h"
#include "CarryState.h"
#include "CollectivePipeline.h"
#include "ControllerRanks.h"
#include "FilterRuntime.h"
#include "Fractions/GhostFractions.h"
#include "Fractions/RefineCells.h"
#include "InputFields.h"
#include "InputLevels.h"
#include "LabelNames.h"
#include "Labels/SmallRegions.h"
#include "Labels/SmoothLabels.h"
#include "LevelFields.h"
#include "LevelSetup.h"
#include "MaterialArrays.h"
#include "MeshOutput.h"
#include "MissingLevels.h"
#include "ReportOutput.h"

#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkLogger.h"
#include "vtkMultiProcessController.h"
#include "vtkPointData.h"
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
constexpr double LabelVolumeTolerance = 1e-6; // relative, of smoothed labels

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

vfm::MeshOptions vtkVolumeFractionMeshAlgorithm::GetOptions() const
{
  vfm::MeshOptions options;
  options.IsoValue = this->IsoValue;
  options.MeshVoid = this->MeshVoid;
  options.StairStep = this->StairStep;
  options.Method = static_cast<vfm::Smoothing>(this->Smoothing);
  options.Edges = static_cast<vfm::SharpEdges>(this->SharpEdges);
  options.TargetScaledJacobian = this->TargetScaledJacobian;
  options.ConserveVolume = this->ConserveVolume;
  options.ComputeQuality = this->ComputeQuality;
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
  const int threads = vfm::FilterRuntime::ChooseThreads(this->Controller, this->NumberOfThreads);
  vfm::FilterRuntime::Execute(this, this->Controller, threads, outputVector,
    [&](vfm::MessageRanks& ranks) { this->Run(input, ranks, outputs); });
  return 1;
}

/// Collective: removes small regions, smooths labels and cuts long cells, as asked.
vfm::RemovedRegions vtkVolumeFractionMeshAlgorithm::PrepareFractions(
  vfm::LevelFields& fields, bool areLabels, vfm::Runtime& runtime)
{
  vfm::FractionField& fractions = fields.Field.Fractions;
  vfm::RemovedRegions removed;
  if (this->MinimumRegionCells > 1)
  {
    runtime.Progress(0.0, "Removing small regions");
    removed = vfm::RemoveSmallRegions(fields.Grid, this->MinimumRegionCells, this->IsoValue,
      vfm::Partition(fields.Grid, runtime.Group()), fractions);
  }
  if (this->LabelSmoothing > 0 && areLabels)
  {
    runtime.Progress(0.0, "Smoothing labels");
    const double error = vfm::SmoothLabels(fields.Grid, this->LabelSmoothing,
      vfm::Partition(fields.Grid, runtime.Group()), runtime, fractions);
    if (runtime.Group().Rank() == 0 && error > LabelVolumeTolerance)
    {
      vtkWarningMacro(<< "Smoothing could not keep the volumes of all labels: the worst is off by "
                      << 100.0 * error << " %. Fewer passes, or MinimumRegionCells, may help.");
    }
  }
  // after labels: the parts of a slice would keep its steps
  vfm::DivideFields(
    fields, this->MaximumAspectRatio, static_cast<vfm::ChildRule>(this->ChildFractions), runtime);
  return removed;
}

/// Collective: the cells that are to be refined by name.
vfm::InputWishes vtkVolumeFractionMeshAlgorithm::FindWishes(
  const vfm::InputLevels& input, vfm::Ranks& ranks) const
{
  std::string array;
  std::vector<vfm::RefinementBox> boxes;
  if (this->Refinement == REFINEMENT_AUTOMATIC)
  {
    array = this->GetNamedRefinementArray();
    for (const std::array<double, 7>& b : this->RefinementBoxes)
    {
      boxes.push_back({ { { b[0], b[1], b[2] } }, { { b[3], b[4], b[5] } }, b[6] });
    }
  }
  const vfm::InputWishes wishes = vfm::FindInputWishes(input, array, boxes, ranks);
  this->Warn(wishes.Warning, ranks);
  return wishes;
}

/// Collective.
vfm::LevelSetup vtkVolumeFractionMeshAlgorithm::SetUpLevels(
  const vfm::InputLevels& input, const vfm::InputWishes& wishes, vfm::Ranks& ranks) const
{
  const int alignment = this->HasFaceNeighbours
    ? vfm::CountAlignedLevels(input.Levels[0].Boxes(), ranks)
    : vfm::AnyLevel;
  const vfm::LevelSetup setup = vfm::DecideLevels(static_cast<vfm::Refinement>(this->Refinement),
    this->MaximumLevel, input.Levels[0].Coordinates, input.Finest(), alignment, wishes.Finest);
  this->Warn(setup.Warning, ranks);
  return setup;
}

/// Collective: makes the grid as fine as the finest cells of the mesh, with the ghost layers that meshing needs.
vfm::LevelPlan vtkVolumeFractionMeshAlgorithm::Refine(const vfm::LevelSetup& setup, int inputFinest,
  const vfm::InputWishes& wishes, vfm::LevelFields& fields, vfm::Runtime& runtime) const
{
  int finer = setup.Finest - std::min(setup.Finest, inputFinest);
  if (this->Refinement == REFINEMENT_AUTOMATIC)
  {
    runtime.Progress(0.0, "Looking for places to refine");
    const int layers = this->KeepsInterfacesFine() ? 0 : this->FineLayers;
    vfm::RefinementCriteria criteria;
    criteria.ThinCells = this->ThinCells;
    criteria.CurvaturePerCell = this->CurvaturePerCell;
    criteria.FlippedCells = this->RefineFlippedCells;
    criteria.InterfaceLayers = this->InterfaceLayers;
    criteria.MaximumLevel = finer;
    vfm::WorkTogether(
      runtime.Group(), [&] { criteria.Chosen = vfm::TakeWishes(wishes, setup, layers, fields); });
    if (finer > 0)
    {
      finer = vfm::FindFinerLevels(fields, criteria, this->IsoValue, layers, runtime);
    }
  }
  vfm::RefineFields(fields, finer, static_cast<vfm::ChildRule>(this->ChildFractions), runtime);
  vfm::LevelPlan plan;
  plan.FineInterfaces = this->KeepsInterfacesFine();
  plan.FineLayers = this->FineLayers;
  if (!setup.IsUniform)
  {
    plan.Refinements = std::min(setup.Finest, inputFinest) - setup.Base + finer;
    plan.Families = std::move(fields.Families);
  }
  if (vfm::InterfacesCrossLevels(plan))
  {
    vfm::WidenGrid(vfm::LayersFor(plan), runtime.Group(), fields.Grid, fields.Field.Fractions);
  }
  return plan;
}

/// On the first rank, unless the text is empty.
void vtkVolumeFractionMeshAlgorithm::Warn(const std::string& text, const vfm::Ranks& ranks) const
{
  if (ranks.Rank() == 0 && !text.empty())
  {
    vtkWarningMacro(<< text);
  }
}

/// Of what may surprise in the mesh.
void vtkVolumeFractionMeshAlgorithm::WarnOfMesh(
  const vfm::MeshReport& report, const vfm::InputField& field, const vfm::Ranks& ranks) const
{
  const vfm::MendedCells& mended = field.Mended;
  if (mended.Clipped > 0)
  {
    this->Warn("Volume fractions of " + std::to_string(mended.Clipped) +
        " cells lay outside [0, 1] and were clipped.",
      ranks);
  }
  if (mended.Normalised > 0)
  {
    this->Warn("The volume fractions of " + std::to_string(mended.Normalised) +
        " cells sum to slightly more than 1 and were scaled back.",
      ranks);
  }
  const bool isEmpty = std::all_of(report.Materials.begin(), report.Materials.end(),
    [](const vfm::MeshReport::Material& material) { return material.Elements == 0; });
  this->Warn(isEmpty ? "The mesh is empty: no cell is filled by its materials to the iso value."
                     : vfm::DescribeLostMaterials(report, field.Table),
    ranks);
}

/// Collective.
vfm::InputLevels vtkVolumeFractionMeshAlgorithm::FindLevels(
  vtkDataObject* input, const vfm::ArraysToRead& arrays, vfm::Ranks& ranks) const
{
  AgreeOn(this->HasFaceNeighbours, ranks);
  return this->HasFaceNeighbours
    ? vfm::FindNeighbourLevels(input, arrays, this->FaceNeighbours, ranks)
    : vfm::FindInputLevels(input, arrays, ranks);
}

void vtkVolumeFractionMeshAlgorithm::SetState(
  const vfm::CarriedState& carried, const vfm::Ranks& ranks, const vfm::MeshOutputs& outputs) const
{
  for (vtkDataArray* array : carried.Arrays)
  {
    outputs.Mesh->GetCellData()->AddArray(array);
  }
  if (carried.NodalVelocity)
  {
    outputs.Mesh->GetPointData()->AddArray(carried.NodalVelocity);
  }
  if (carried.IsConserved)
  {
    vfm::SetStateOutput(carried.Balance, this->MeshVoid, outputs.Mesh->GetFieldData());
    if (ranks.Rank() == 0)
    {
      vfm::AddStateColumns(carried.Balance, this->MeshVoid, outputs.Materials);
    }
  }
}

void vtkVolumeFractionMeshAlgorithm::Run(
  vtkDataObject* input, vfm::MessageRanks& ranks, const vfm::MeshOutputs& outputs)
{
  vtkUnstructuredGrid* output = outputs.Mesh;
  this->Warn(vfm::DescribeMissingLevels(input, ranks), ranks);
  const vfm::MaterialArrays materials = this->FindMaterials(input, ranks);
  vfm::FilterRuntime runtime(this, &ranks);
  runtime.Progress(0.0, "Reading input");
  const vfm::LabelNames names =
    vfm::ShareLabelNames(materials.HasLabels() ? this->LabelNamesFile : "", ranks);
  const vfm::StateChoice state = this->ChooseState(input, ranks);
  const vfm::InputLevels levels =
    this->FindLevels(input, this->ListArrays(materials, state), ranks);
  const vfm::LevelCells cells = materials.HasLabels()
    ? vfm::OpenLabels(levels.Levels, materials.Labels.Name, ranks)
    : vfm::OpenFractions(
        levels.Levels, vfm::NamesOf(materials.Fractions), this->FractionTolerance, ranks);
  vfm::StateCarrier states(levels, state, ranks);
  vfm::InputWishes wishes = this->FindWishes(levels, ranks);
  const vfm::LevelSetup setup = this->SetUpLevels(levels, wishes, ranks);
  const std::vector<vfm::BlockPlace> owners = this->HasFaceNeighbours
    ? levels.Levels[0].Places
    : vfm::ShareOutCells(levels, cells, setup, ranks);
  wishes = vfm::ShareOutWishes(wishes, levels, owners, ranks);
  vfm::LevelFields fields = vfm::MakeLevelFields(
    levels, cells, setup, static_cast<vfm::ChildRule>(this->ChildFractions), owners, runtime);
  vfm::NameLabels(names, fields.Field.Table);
  states.Keep(cells, fields, setup, this->MeshVoid, owners, runtime);
  const vfm::RemovedRegions removed =
    this->PrepareFractions(fields, materials.HasLabels(), runtime);
  vfm::MeshOptions options = this->GetOptions();
  options.Levels = this->Refine(setup, levels.Finest(), wishes, fields, runtime);
  const int finest = setup.IsUniform ? setup.Finest : setup.Base + options.Levels.Refinements;
  const vfm::CartesianGrid& grid = fields.Grid;
  const vfm::InputField& field = fields.Field;
  vfm::MeshReport report;
  vfm::Mesh mesh = this->MakeMesh(grid, field.Fractions, options, runtime, report);
  report.RemovedRegions = removed.Regions;
  report.RemovedCells = removed.Cells;
  report.ChosenCells = wishes.Cells;
  LogStages(report);
  runtime.Progress(0.98, "Filling output");
  const vfm::MeshedGrid meshed{ grid, field.Fractions, finest,
    fields.Division.OfHalves(finest - setup.Base) };
  const vfm::CarriedState carried =
    states.Carry(mesh, meshed, this->GetConserveOptions(), owners, runtime);
  vfm::WorkTogether(ranks,
    [&]
    {
      vfm::TurnMesh(levels.Reading.Frame, mesh);
      vfm::SetMeshOutput(mesh, field.Table, outputs);
      vfm::SetReportOutput(mesh, report, field.Table, options, field.Mended, output);
      if (ranks.Rank() == 0) // views show the rows of all ranks
      {
        vfm::SetMaterialTable(report, field.Table, options, outputs.Materials);
      }
      vfm::SetDomainOutput(grid, levels.Reading.Frame, output);
      this->SetState(carried, ranks, outputs);
    });
  LogTraffic(ranks);
  this->WarnOfMesh(report, field, ranks);
  this->Warn(vfm::DescribeUnmeshed(carried.Balance, field.Table), ranks);
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
