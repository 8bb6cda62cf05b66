#include "vtkVolumeFractionVoxelReader.h"

#include "Images/ImageSource.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkVolumeFractionVoxelReader);

vfm::ImageSource vtkVolumeFractionVoxelReader::Open()
{
  return vfm::OpenVoxels(this->FileName,
    { this->Dimensions[0], this->Dimensions[1], this->Dimensions[2] },
    { { this->Origin[0], this->Origin[1], this->Origin[2] } },
    { { this->Spacing[0], this->Spacing[1], this->Spacing[2] } },
    static_cast<vfm::AxisOrder>(this->AxisOrder));
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
