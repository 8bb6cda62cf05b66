#include "HostWishes.h"

#include "vtkVolumeFractionMeshAlgorithm.h"

#include <algorithm>

namespace vfm
{
namespace
{

constexpr const char* ArrayName = "CellHalvings";

} // namespace

bool HostWishes::AddTo(HostGrid& grid, Ranks& ranks)
{
  const bool isNamed = std::any_of(this->Halvings.begin(), this->Halvings.end(),
    [](const auto& box) { return box.second != nullptr; });
  if (!ranks.Any(isNamed))
  {
    return false;
  }
  this->Zeros.resize(grid.Boxes.size());
  for (std::size_t b = 0; b < grid.Boxes.size(); ++b)
  {
    const int* halvings = this->Halvings[b];
    if (!halvings)
    {
      this->Zeros[b].resize(grid.Boxes[b].Cells.NumberOfCells());
      halvings = this->Zeros[b].data();
    }
    grid.Boxes[b].Arrays.push_back(MakeHostArray(ArrayName, halvings));
  }
  return true;
}

NamedRefinement::NamedRefinement(vtkVolumeFractionMeshAlgorithm& mesher, bool areNamed) :
  Mesher(mesher),
  Array(mesher.GetRefinementArray()),
  Refinement(mesher.GetRefinement()),
  MaximumLevel(mesher.GetMaximumLevel()),
  InterfaceLayers(mesher.GetInterfaceLayers()),
  ThinCells(mesher.GetThinCells()),
  CurvaturePerCell(mesher.GetCurvaturePerCell()),
  RefineFlippedCells(mesher.GetRefineFlippedCells())
{
  if (!areNamed)
  {
    return;
  }
  mesher.SetRefinementArray(ArrayName);
  const int automatic = vtkVolumeFractionMeshAlgorithm::REFINEMENT_AUTOMATIC;
  if (this->Refinement != automatic || this->MaximumLevel == 0) // then nothing else asks
  {
    mesher.SetRefinement(automatic);
    mesher.SetMaximumLevel(this->MaximumLevel == 0 ? -1 : this->MaximumLevel);
    mesher.SetThinCells(0.0);
    mesher.SetCurvaturePerCell(0.0);
    mesher.SetRefineFlippedCells(false);
    mesher.SetInterfaceLayers(0);
  }
}

NamedRefinement::~NamedRefinement()
{
  this->Mesher.SetRefinementArray(this->Array.c_str());
  this->Mesher.SetRefinement(this->Refinement);
  this->Mesher.SetMaximumLevel(this->MaximumLevel);
  this->Mesher.SetThinCells(this->ThinCells);
  this->Mesher.SetCurvaturePerCell(this->CurvaturePerCell);
  this->Mesher.SetRefineFlippedCells(this->RefineFlippedCells);
  this->Mesher.SetInterfaceLayers(this->InterfaceLayers);
}

} // namespace vfm
