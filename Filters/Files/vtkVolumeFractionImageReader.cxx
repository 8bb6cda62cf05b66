#include "vtkVolumeFractionImageReader.h"

#include "Images/ImageSource.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkVolumeFractionImageReader);

vfm::ImageSource vtkVolumeFractionImageReader::Open()
{
  vfm::ImageRequest request{ this->CellArray, std::nullopt };
  if (this->Volume >= 0)
  {
    request.Volume = this->Volume;
  }
  return vfm::OpenImage(
    this->FileName, { { this->Spacing[0], this->Spacing[1], this->Spacing[2] } }, request);
}

void vtkVolumeFractionImageReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Spacing: " << this->Spacing[0] << " " << this->Spacing[1] << " "
     << this->Spacing[2] << "\n";
  os << indent << "CellArray: " << this->CellArray << "\n";
  os << indent << "Volume: " << this->Volume << "\n";
}
