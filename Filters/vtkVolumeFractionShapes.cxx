#include "vtkVolumeFractionShapes.h"

#include "AdoptBuffer.h"
#include "CollectivePipeline.h"
#include "FilterRuntime.h"
#include "Shapes/ShapesFractions.h"
#include "Shapes/ShapesScenes.h"
#include "Shapes/ShapesText.h"
#include "SurfaceShape.h"

#include "vtkBoundingBox.h"
#include "vtkCellData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <cmath>

using Pipeline = vtkStreamingDemandDrivenPipeline;

vtkStandardNewMacro(vtkVolumeFractionShapes);

namespace
{

constexpr int Margin = 2; // cells between surfaces and the sides of a fitted grid

struct Placement
{
  double Origin[3], Spacing[3];
};

Placement PlaceInBounds(const double bounds[6], const int dimensions[3])
{
  Placement place;
  for (int a = 0; a < 3; ++a)
  {
    place.Origin[a] = bounds[2 * a];
    place.Spacing[a] = (bounds[2 * a + 1] - bounds[2 * a]) / dimensions[a];
  }
  return place;
}

/// Places cubic cells around all surfaces, centred.
Placement PlaceAround(const std::vector<vtkPolyData*>& surfaces, const int dimensions[3])
{
  vtkBoundingBox box;
  for (vtkPolyData* surface : surfaces)
  {
    box.AddBounds(surface->GetBounds());
  }
  if (!box.IsValid())
  {
    throw vfm::InputError("FitToInput needs a surface on the input.");
  }
  double width = 0.0, center[3];
  box.GetCenter(center);
  for (int a = 0; a < 3; ++a)
  {
    if (dimensions[a] <= 2 * Margin)
    {
      throw vfm::InputError("FitToInput needs Dimensions of at least 5 along every axis.");
    }
    width = std::max(width, box.GetLength(a) / (dimensions[a] - 2 * Margin));
  }
  Placement place;
  for (int a = 0; a < 3; ++a)
  {
    place.Origin[a] = center[a] - 0.5 * width * dimensions[a];
    place.Spacing[a] = width;
  }
  return place;
}

std::array<std::vector<double>, 3> ListCoordinates(const Placement& place, const int dimensions[3])
{
  std::array<std::vector<double>, 3> coordinates;
  for (int a = 0; a < 3; ++a)
  {
    for (int i = 0; i <= dimensions[a]; ++i)
    {
      coordinates[a].push_back(place.Origin[a] + i * place.Spacing[a]);
    }
  }
  return coordinates;
}

std::vector<vfm::Shape> MakePreset(int preset, const vfm::Vector3& lower, const vfm::Vector3& upper)
{
  if (vtkVolumeFractionShapes::GetPresetName(preset).empty())
  {
    throw vfm::InputError("Preset " + std::to_string(preset) + " does not exist.");
  }
  return vfm::MakeScene(static_cast<vfm::Scene>(preset - 1), lower, upper);
}

bool HasCells(const int extent[6])
{
  return extent[0] < extent[1] && extent[2] < extent[3] && extent[4] < extent[5];
}

} // namespace

vtkVolumeFractionShapes::vtkVolumeFractionShapes()
{
  this->SetNumberOfInputPorts(1);
}

vtkExecutive* vtkVolumeFractionShapes::CreateDefaultExecutive()
{
  return vfm::CollectivePipeline::Make([] { return nullptr; });
}

int vtkVolumeFractionShapes::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  return 1;
}

std::string vtkVolumeFractionShapes::GetPresetName(int preset)
{
  if (preset < 0 || preset > static_cast<int>(vfm::Scene::NumberOfScenes))
  {
    return "";
  }
  return preset == 0 ? "None" : vfm::GetSceneName(static_cast<vfm::Scene>(preset - 1));
}

std::string vtkVolumeFractionShapes::FindGridError() const
{
  for (int a = 0; a < 3; ++a)
  {
    if (this->Dimensions[a] < 1)
    {
      return "Dimensions are numbers of cells: each must be at least 1.";
    }
    const double edge = this->Bounds[2 * a + 1] - this->Bounds[2 * a];
    if (!this->FitToInput && !(edge > 0.0 && std::isfinite(edge)))
    {
      return "Bounds are empty: every minimum must lie below its maximum.";
    }
  }
  return "";
}

int vtkVolumeFractionShapes::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  // RequestData reports an invalid grid, once.
  const bool valid = this->FindGridError().empty();
  vtkInformation* info = outputVector->GetInformationObject(0);
  int extent[6] = { 0, -1, 0, -1, 0, -1 };
  for (int a = 0; a < 3 && valid; ++a)
  {
    extent[2 * a + 1] = this->Dimensions[a];
  }
  info->Set(Pipeline::WHOLE_EXTENT(), extent, 6);
  info->Remove(vtkDataObject::ORIGIN());
  info->Remove(vtkDataObject::SPACING());
  if (valid && !this->FitToInput) // otherwise the surfaces are needed
  {
    const Placement place = PlaceInBounds(this->Bounds, this->Dimensions);
    info->Set(vtkDataObject::ORIGIN(), place.Origin, 3);
    info->Set(vtkDataObject::SPACING(), place.Spacing, 3);
  }
  info->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
  return 1;
}

int vtkVolumeFractionShapes::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  for (int i = 0; i < inputVector[0]->GetNumberOfInformationObjects(); ++i)
  {
    vtkInformation* info = inputVector[0]->GetInformationObject(i);
    info->Set(Pipeline::UPDATE_PIECE_NUMBER(), 0);
    info->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), 1);
    info->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
  }
  return 1;
}

int vtkVolumeFractionShapes::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInformation* info = outputVector->GetInformationObject(0);
  vtkImageData* image = vtkImageData::GetData(info);
  int extent[6];
  info->Get(Pipeline::UPDATE_EXTENT(), extent);
  vfm::FilterRuntime::Execute(
    this, nullptr, outputVector, [&](vfm::Ranks&) { this->Fill(inputVector[0], extent, image); });
  return 1;
}

void vtkVolumeFractionShapes::Fill(
  vtkInformationVector* inputs, const int extent[6], vtkImageData* image)
{
  const std::string problem = this->FindGridError();
  if (!problem.empty())
  {
    throw vfm::InputError(problem);
  }
  std::vector<vtkPolyData*> surfaces;
  for (int i = 0; i < inputs->GetNumberOfInformationObjects(); ++i)
  {
    surfaces.push_back(vtkPolyData::GetData(inputs, i));
  }
  const Placement place = this->FitToInput ? PlaceAround(surfaces, this->Dimensions)
                                           : PlaceInBounds(this->Bounds, this->Dimensions);
  const std::array<std::vector<double>, 3> coordinates = ListCoordinates(place, this->Dimensions);
  vfm::Vector3 lower, upper;
  for (int a = 0; a < 3; ++a)
  {
    lower[a] = coordinates[a].front();
    upper[a] = coordinates[a].back();
  }
  std::vector<vfm::Shape> shapes = vfm::ParseShapes(this->Shapes, lower, upper);
  if (shapes.empty() && this->Preset != 0)
  {
    shapes = MakePreset(this->Preset, lower, upper);
  }
  for (vtkPolyData* surface : surfaces)
  {
    const int next = vfm::CountMaterials(shapes) + 1;
    const int material = this->SurfaceMaterial == 0 ? next : this->SurfaceMaterial;
    shapes.push_back(vfm::MakeSurfaceShape(material, surface));
  }
  if (shapes.empty())
  {
    throw vfm::InputError("There is no shape: choose a preset, write shapes, or give a surface.");
  }
  image->SetExtent(const_cast<int*>(extent));
  image->SetOrigin(place.Origin);
  image->SetSpacing(place.Spacing);
  const bool hasCells = HasCells(extent); // otherwise the image may have flat cells
  std::vector<vfm::Buffer<double>> fractions(vfm::CountMaterials(shapes));
  if (hasCells)
  {
    vtkMultiProcessController* processes = vtkMultiProcessController::GetGlobalController();
    vfm::FilterRuntime runtime(this,
      vfm::ChooseThreads(this->NumberOfThreads, processes ? processes->GetNumberOfProcesses() : 1));
    const vfm::IndexBox cells{ { extent[0], extent[2], extent[4] },
      { extent[1], extent[3], extent[5] } };
    fractions = vfm::FractionArraysOfShapes(coordinates, cells, shapes, this->Tolerance, runtime);
  }
  for (std::size_t m = 0; m < fractions.size(); ++m)
  {
    vfm::Buffer<double> values =
      hasCells ? std::move(fractions[m]) : vfm::Buffer<double>(image->GetNumberOfCells(), 0.0);
    const std::string name = "Material" + std::to_string(m + 1);
    image->GetCellData()->AddArray(vfm::AdoptBuffer(values, name.c_str()));
  }
}

void vtkVolumeFractionShapes::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Dimensions: " << this->Dimensions[0] << " " << this->Dimensions[1] << " "
     << this->Dimensions[2] << "\n";
  os << indent << "Bounds:";
  for (double bound : this->Bounds)
  {
    os << " " << bound;
  }
  os << "\n";
  os << indent << "FitToInput: " << this->FitToInput << "\n";
  os << indent << "Preset: " << this->GetPresetName(this->Preset) << "\n";
  os << indent << "Shapes: " << this->Shapes << "\n";
  os << indent << "SurfaceMaterial: " << this->SurfaceMaterial << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
}
