#include "HostRefinement.h"

#include <algorithm>

namespace vfm
{
namespace
{

constexpr const char* ArrayName = "CellHalvings";

} // namespace

bool HostRefinement::AddTo(HostGrid& grid, Ranks& ranks)
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

void RefineNamedCells(MesherOptions& options)
{
  options.RefinementArray = ArrayName;
  if (options.Refinement != RefinementMode::Automatic ||
    options.MaximumLevel == 0) // no other refinement
  {
    options.Refinement = RefinementMode::Automatic;
    options.MaximumLevel = options.MaximumLevel == 0 ? -1 : options.MaximumLevel;
    options.ThinCells = 0.0;
    options.CurvaturePerCell = 0.0;
    options.RefineFlippedCells = false;
    options.InterfaceLayers = 0;
  }
}

} // namespace vfm
