#include "vtkVolumeFractionImageReader.h"

#include "Images/ImageSource.h"
#include "InputTrust.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkVolumeFractionImageReader);

vfm::ImageSource vtkVolumeFractionImageReader::Open()
{
  vfm::ImageRequest request{ this->CellArray, std::nullopt };
  if (this->Volume >= 0)
  {
    request.Volume = this->Volume;
  }
  const bool isTrusted = this->TrustInput;
  const vfm::InputTrust trust(isTrusted);
  vfm::ImageSource source = vfm::OpenImage(
    this->FileName, { { this->Spacing[0], this->Spacing[1], this->Spacing[2] } }, request);
  source.Read = [read = source.Read, isTrusted](const vfm::IndexBox& box, vfm::Ranks& ranks)
  {
    const vfm::InputTrust again(isTrusted);
    return read(box, ranks);
  };
  return source;
}

void vtkVolumeFractionImageReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Spacing: " << this->Spacing[0] << " " << this->Spacing[1] << " "
     << this->Spacing[2] << "\n";
  os << indent << "CellArray: " << this->CellArray << "\n";
  os << indent << "Volume: " << this->Volume << "\n";
  os << indent << "TrustInput: " << this->TrustInput << "\n";
}
