#include "vtkVolumeFractionImageReader.h"

#include "Images/ImageSource.h"
#include "InputTrust.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkVolumeFractionImageReader);

vfm::ImageSource vtkVolumeFractionImageReader::Open()
{
  vfm::ImageRequest request;
  request.Array = this->CellArray;
  request.Slices = this->Slices;
  if (this->Volume >= 0)
  {
    request.Volume = this->Volume;
  }
  if (request.Slices.size() == 1) // a file of several slices, a folder or a pattern
  {
    request.Slices.clear();
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

void vtkVolumeFractionImageReader::AddSlice(const char* path)
{
  this->Slices.emplace_back(path ? path : "");
  this->FileName = this->Slices.size() == 1 ? this->Slices[0] : this->FileName;
  this->Modified();
}

void vtkVolumeFractionImageReader::RemoveAllSlices()
{
  this->Slices.clear();
  this->Modified();
}

void vtkVolumeFractionImageReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Spacing: " << this->Spacing[0] << " " << this->Spacing[1] << " "
     << this->Spacing[2] << "\n";
  os << indent << "CellArray: " << this->CellArray << "\n";
  os << indent << "Volume: " << this->Volume << "\n";
  os << indent << "Slices:";
  for (const std::string& slice : this->Slices)
  {
    os << " " << slice;
  }
  os << "\n";
  os << indent << "TrustInput: " << this->TrustInput << "\n";
}
