#include "vtkVolumeFractionShapes.h"

#include "AdoptBuffer.h"
#include "BodyOfPolyData.h"
#include "CollectivePipeline.h"
#include "FilterRuntime.h"
#include "Shapes/PlaceGrid.h"
#include "Shapes/ShapesFractions.h"
#include "Shapes/ShapesScenes.h"
#include "Shapes/ShapesText.h"
#include "SurfaceFields.h"
#include "Surfaces/SurfaceFractions.h"

#include "vtkCellData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <numeric>

using Pipeline = vtkStreamingDemandDrivenPipeline;

vtkStandardNewMacro(vtkVolumeFractionShapes);

namespace
{

vfm::GridPlace PlaceInBounds(const double bounds[6], const int dimensions[3])
{
  vfm::GridPlace place;
  for (int a = 0; a < 3; ++a)
  {
    place.Origin[a] = bounds[2 * a];
    place.Widths[a] = (bounds[2 * a + 1] - bounds[2 * a]) / dimensions[a];
    place.Cells[a] = dimensions[a];
  }
  return place;
}

vfm::GridPlace PlaceAround(const vfm::InputSurfaces& surfaces, const int dimensions[3])
{
  if (surfaces.Bodies.empty())
  {
    throw vfm::InputError("FitToInput needs a surface on the input.");
  }
  if (*std::min_element(dimensions, dimensions + 3) < vfm::LeastPlacedCells)
  {
    throw vfm::InputError("FitToInput needs Dimensions of at least 5 along every axis.");
  }
  return vfm::PlaceCells(
    vfm::FindBounds(surfaces), { { dimensions[0], dimensions[1], dimensions[2] } });
}

std::vector<vfm::Shape> MakePreset(int preset, const vfm::Vector3& lower, const vfm::Vector3& upper)
{
  if (vtkVolumeFractionShapes::GetPresetName(preset).empty())
  {
    throw vfm::InputError("Preset " + std::to_string(preset) + " does not exist.");
  }
  return vfm::MakeScene(static_cast<vfm::Scene>(preset - 1), lower, upper);
}

/// Returns the name of the array of a material.
std::string NameOf(std::size_t material)
{
  return "Material" + std::to_string(material);
}

/// Returns the material of each surface.
/// @param given  material of all surfaces; 0: each gets the next free number
/// @param taken  number of materials of the shapes
std::vector<int> NumberSurfaces(std::size_t count, int given, int taken)
{
  if (given < 0)
  {
    throw vfm::InputError("SurfaceMaterial is " + std::to_string(given) +
      ": materials are numbered from 1, and 0 is automatic.");
  }
  std::vector<int> materials(count, given);
  if (given == 0)
  {
    std::iota(materials.begin(), materials.end(), taken + 1);
  }
  return materials;
}

/// Returns the bodies of surfaces, without names.
vfm::InputSurfaces MakeBodies(vtkInformationVector* surfaces)
{
  vfm::InputSurfaces bodies;
  for (int i = 0; i < surfaces->GetNumberOfInformationObjects(); ++i)
  {
    bodies.Bodies.push_back(vfm::MakeBodyOfPolyData("", vtkPolyData::GetData(surfaces, i)));
  }
  return bodies;
}

/// Returns one array per material. An array is empty if no shape or surface has the material.
/// @param shapes  fractions of the materials of the shapes
/// @param surfaces  fractions of the surfaces, which give way to the shapes
/// @param materials  material of each surface
std::vector<vfm::Buffer<double>> Combine(std::vector<vfm::Buffer<double>> shapes,
  std::vector<vfm::Buffer<double>> surfaces, const std::vector<int>& materials,
  vfm::Runtime& runtime)
{
  const std::size_t count = shapes.size();
  std::vector<vfm::Buffer<double>> all = std::move(shapes);
  std::move(surfaces.begin(), surfaces.end(), std::back_inserter(all));
  if (count > 0 && !materials.empty())
  {
    vfm::LimitSums(all, runtime);
  }
  std::vector<vfm::Buffer<double>> sums(count);
  std::move(all.begin(), all.begin() + count, sums.begin());
  for (std::size_t s = 0; s < materials.size(); ++s)
  {
    sums.resize(std::max<std::size_t>(sums.size(), materials[s]));
    vfm::Buffer<double>&sum = sums[materials[s] - 1], &values = all[count + s];
    if (sum.empty())
    {
      sum = std::move(values);
      continue;
    }
    std::transform(sum.begin(), sum.end(), values.begin(), sum.begin(), std::plus<double>());
  }
  return sums;
}

/// Adds the arrays of all materials to an image; zeros for an empty array.
void AddFractions(std::vector<vfm::Buffer<double>>& fractions, vtkImageData* image)
{
  for (std::size_t m = 0; m < fractions.size(); ++m)
  {
    vfm::Buffer<double> values = fractions[m].empty()
      ? vfm::Buffer<double>(image->GetNumberOfCells(), 0.0)
      : std::move(fractions[m]);
    image->GetCellData()->AddArray(vfm::AdoptBuffer(values, NameOf(m + 1).c_str()));
  }
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
    const vfm::GridPlace place = PlaceInBounds(this->Bounds, this->Dimensions);
    info->Set(vtkDataObject::ORIGIN(), place.Origin.data(), 3);
    info->Set(vtkDataObject::SPACING(), place.Widths.data(), 3);
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
  vfm::InputSurfaces bodies = MakeBodies(inputs);
  const vfm::GridPlace place = this->FitToInput ? PlaceAround(bodies, this->Dimensions)
                                                : PlaceInBounds(this->Bounds, this->Dimensions);
  const std::array<std::vector<double>, 3> coordinates = vfm::ListNodes(place);
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
  const int taken = vfm::CountMaterials(shapes);
  const std::vector<int> materials =
    NumberSurfaces(bodies.Bodies.size(), this->SurfaceMaterial, taken);
  for (std::size_t b = 0; b < materials.size(); ++b)
  {
    bodies.Bodies[b].Name = NameOf(materials[b]);
  }
  if (shapes.empty() && materials.empty())
  {
    throw vfm::InputError("There is no shape: choose a preset, write shapes, or give a surface.");
  }
  image->SetExtent(const_cast<int*>(extent));
  image->SetOrigin(place.Origin.data());
  image->SetSpacing(place.Widths.data());
  std::vector<vfm::Buffer<double>> fractions(
    materials.empty() ? taken : std::max(taken, materials.back()));
  if (HasCells(extent)) // otherwise the image may have flat cells
  {
    vtkMultiProcessController* processes = vtkMultiProcessController::GetGlobalController();
    vfm::FilterRuntime runtime(this,
      vfm::ChooseThreads(this->NumberOfThreads, processes ? processes->GetNumberOfProcesses() : 1));
    const vfm::IndexBox cells{ { extent[0], extent[2], extent[4] },
      { extent[1], extent[3], extent[5] } };
    std::vector<vfm::Buffer<double>> ofShapes;
    if (!shapes.empty())
    {
      ofShapes = vfm::FractionArraysOfShapes(coordinates, cells, shapes, this->Tolerance, runtime);
    }
    fractions = Combine(std::move(ofShapes),
      vfm::FractionsOfSurfaces(coordinates, cells, bodies, runtime), materials, runtime);
  }
  AddFractions(fractions, image);
  vfm::AddSurfaceFields(vfm::FlattenSurfaces(bodies), image->GetFieldData());
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
