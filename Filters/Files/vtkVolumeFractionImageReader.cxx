#include "vtkVolumeFractionImageReader.h"

#include "Images/DealImage.h"
#include "Images/ImageFile.h"
#include "Ranks/Errors.h"

#include "vtkObjectFactory.h"

#include <algorithm>

vtkStandardNewMacro(vtkVolumeFractionImageReader);

vtkVolumeFractionImageReader::vtkVolumeFractionImageReader() : File(new vfm::ImageFile) {}

vtkVolumeFractionImageReader::~vtkVolumeFractionImageReader() = default;

vfm::ImagePlace vtkVolumeFractionImageReader::Open(bool& areOfCells)
{
  const bool isSet =
    std::any_of(this->Spacing, this->Spacing + 3, [](double s) { return s != 0.0; });
  if (isSet && !std::all_of(this->Spacing, this->Spacing + 3, [](double s) { return s > 0.0; }))
  {
    throw vfm::InputError("Spacing must be above 0 along all axes, or 0 for that of the file.");
  }
  *this->File = vfm::OpenImageFile(this->FileName, this->CellArray);
  if (isSet)
  {
    this->File->Place.Spacing = { { this->Spacing[0], this->Spacing[1], this->Spacing[2] } };
  }
  areOfCells = this->File->IsOfCells;
  return this->File->Place;
}

std::vector<vfm::TypedValues> vtkVolumeFractionImageReader::ReadBox(
  const vfm::IndexBox& box, vfm::Ranks& ranks)
{
  std::vector<vfm::TypedValues> arrays;
  arrays.push_back(vfm::ReadPart(*this->File, box, ranks));
  const char* name = vfm::IsRealType(arrays[0].Type) ? "Values" : "Labels";
  arrays[0].Name = this->File->IsOfCells ? this->CellArray : name;
  return arrays;
}

void vtkVolumeFractionImageReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Spacing: " << this->Spacing[0] << " " << this->Spacing[1] << " "
     << this->Spacing[2] << "\n";
  os << indent << "CellArray: " << this->CellArray << "\n";
}
