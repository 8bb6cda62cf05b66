#include "vtkVolumeFractionVoxelReader.h"

#include "Images/ImagePlace.h"
#include "Ranks/Errors.h"
#include "ReadVoxels.h"

#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkVolumeFractionVoxelReader);

vfm::VoxelFile vtkVolumeFractionVoxelReader::Inspect() const
{
  return vfm::InspectVoxels(this->FileName,
    { this->Dimensions[0], this->Dimensions[1], this->Dimensions[2] },
    static_cast<vfm::AxisOrder>(this->AxisOrder));
}

vfm::ImagePlace vtkVolumeFractionVoxelReader::Open(bool& areOfCells)
{
  vfm::ImagePlace place;
  areOfCells = true;
  for (int a = 0; a < 3; ++a)
  {
    if (!(this->Spacing[a] > 0.0) || !std::isfinite(this->Spacing[a] + this->Origin[a]))
    {
      throw vfm::InputError("Spacing must be above 0, and Origin finite.");
    }
    place.Origin[a] = this->Origin[a];
    place.Spacing[a] = this->Spacing[a];
  }
  const vfm::Index3 cells = this->Inspect().Cells;
  // A text of which the size is not told yet is refused when it is read.
  if (*std::min_element(cells.begin(), cells.end()) > 0)
  {
    place.Size = cells;
  }
  return place;
}

std::vector<vfm::TypedValues> vtkVolumeFractionVoxelReader::ReadBox(
  const vfm::IndexBox& box, vfm::Ranks&)
{
  return vfm::ReadVoxels(this->Inspect(), box);
}

void vtkVolumeFractionVoxelReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto print = [&](const char* name, const auto& values)
  { os << indent << name << ": " << values[0] << " " << values[1] << " " << values[2] << "\n"; };
  print("Dimensions", this->Dimensions);
  print("Origin", this->Origin);
  print("Spacing", this->Spacing);
  os << indent << "AxisOrder: " << this->AxisOrder << "\n";
}
