#include "vtkVolumeFractionImageReader.h"

#include "Images/ImageSource.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkVolumeFractionImageReader);

vfm::ImageSource vtkVolumeFractionImageReader::Open()
{
  return vfm::OpenImage(
    this->FileName, { { this->Spacing[0], this->Spacing[1], this->Spacing[2] } }, this->CellArray);
}

void vtkVolumeFractionImageReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Spacing: " << this->Spacing[0] << " " << this->Spacing[1] << " "
     << this->Spacing[2] << "\n";
  os << indent << "CellArray: " << this->CellArray << "\n";
}
