#include "Images/VtkImageFile.h"

#include "OpenFile.h"
#include "Ranks/Errors.h"
#include "VtkMessages.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkImageReader2.h"
#include "vtkPointData.h"

#include <algorithm>

namespace vfm
{
namespace
{

/// Runs a step of a reader.
template <class Step>
void Watch(vtkImageReader2* reader, bool failsOnWarnings, const Step& step)
{
  VtkMessages messages;
  messages.Watch(reader);
  step();
  if (messages.HasErrors())
  {
    throw InputError(messages.GetErrorText());
  }
  if (failsOnWarnings && !messages.GetWarnings().empty())
  {
    throw InputError(messages.GetWarnings()[0]);
  }
}

} // namespace

VtkImageFile::VtkImageFile(const std::string& path, vtkSmartPointer<vtkImageReader2> reader) :
  Reader(std::move(reader))
{
  OpenFile(path);
  this->Reader->SetFileName(path.c_str());
  Watch(this->Reader, false, [this] { this->Reader->UpdateInformation(); });
  const int* extent = this->Reader->GetDataExtent();
  for (int a = 0; a < 3; ++a)
  {
    this->Where.Size[a] = Index(extent[2 * a + 1]) - extent[2 * a] + 1;
    this->Where.Spacing[a] = this->Reader->GetDataSpacing()[a];
    this->Where.Origin[a] = this->Reader->GetDataOrigin()[a];
  }
  const int components = this->Reader->GetNumberOfScalarComponents();
  if (components != 1)
  {
    throw InputError("it has " + std::to_string(components) +
      " values a point (a vector or a colour); wanted is one, a label or a volume fraction.");
  }
  CheckPlace(this->Where);
}

double VtkImageFile::CountBytes() const
{
  const Index3& size = this->Where.Size;
  return double(size[0]) * double(size[1]) * double(size[2]) *
    vtkDataArray::GetDataTypeSize(this->Reader->GetDataScalarType());
}

vtkSmartPointer<vtkDataArray> VtkImageFile::Read(const IndexBox& box)
{
  int extent[6];
  for (int a = 0; a < 3; ++a)
  {
    extent[2 * a] = static_cast<int>(box.Lower[a]);
    extent[2 * a + 1] = static_cast<int>(box.Upper[a] - 1);
  }
  Watch(this->Reader, true, [&] { this->Reader->UpdateExtent(extent); });
  vtkImageData* image = this->Reader->GetOutput();
  vtkSmartPointer<vtkDataArray> values = image->GetPointData()->GetScalars();
  if (!values || !std::equal(extent, extent + 6, image->GetExtent()) ||
    values->GetNumberOfTuples() != box.NumberOfCells())
  {
    throw InputError("its values cannot be read.");
  }
  image->ReleaseData();
  return values;
}

} // namespace vfm
