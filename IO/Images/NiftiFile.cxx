#include "Base/Vector3.h"
#include "Images/ImageFile.h"
#include "Images/VtkImageFile.h"
#include "OpenFile.h"
#include "Ranks/Errors.h"
#include "SwapBytes.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkMatrix4x4.h"
#include "vtkNIFTIImageHeader.h"
#include "vtkNIFTIImageReader.h"
#include "vtkNew.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <zlib.h>

namespace vfm
{
namespace
{

using Header = vtkNIFTIImageHeader;

constexpr int ValueTypes[] = { Header::TypeUInt8, Header::TypeInt8, Header::TypeUInt16,
  Header::TypeInt16, Header::TypeUInt32, Header::TypeInt32, Header::TypeUInt64, Header::TypeInt64,
  Header::TypeFloat32, Header::TypeFloat64 };

template <class Number>
Number Take(const char* bytes, bool isSwapped)
{
  Number number;
  std::memcpy(&number, bytes, sizeof(Number));
  return isSwapped ? SwapBytes(number) : number;
}

/// VTK's reader runs astray on types of values that it does not know.
void CheckHeader(const std::string& path)
{
  OpenFile(path);
  constexpr std::int32_t length = 348, length2 = 540; // of NIfTI-1 and -2
  std::array<char, length> header{};
  const std::unique_ptr<gzFile_s, int (*)(gzFile)> file(gzopen(path.c_str(), "rb"), gzclose);
  const bool isRead = file && gzread(file.get(), header.data(), length) == length;
  for (bool isSwapped : { false, true })
  {
    const auto told = Take<std::int32_t>(header.data(), isSwapped);
    const bool isFirst = told == length && header[344] == 'n' && header[346] == '1';
    if (isRead && (isFirst || (told == length2 && header[4] == 'n' && header[6] == '2')))
    {
      const auto type = Take<std::int16_t>(header.data() + (isFirst ? 70 : 12), isSwapped);
      if (std::find(std::begin(ValueTypes), std::end(ValueTypes), type) == std::end(ValueTypes))
      {
        throw InputError("its values are of type " + std::to_string(type) +
          " of NIfTI. Read are whole numbers of 1 to 8 bytes, and reals of 4 or 8.");
      }
      return;
    }
  }
  throw InputError("it is no NIfTI file.");
}

class NiftiFile : public VtkImageFile
{
public:
  NiftiFile(const std::string& path, vtkNIFTIImageReader* reader) : VtkImageFile(path, reader)
  {
    CheckLength(path, 0.0, this->CountBytes(), true); // VTK's reader tells of those cut
    if (reader->GetTimeDimension() > 1)
    {
      throw InputError("it holds " + std::to_string(reader->GetTimeDimension()) +
        " images (times, or maps of several regions). Save the one that is meant.");
    }
    this->SetPlace(reader->GetSFormMatrix(), reader->GetQFormMatrix());
    const double slope = reader->GetRescaleSlope(), intercept = reader->GetRescaleIntercept();
    if (slope != 0.0 && std::isfinite(slope) && std::isfinite(intercept)) // else as they are stored
    {
      this->Slope = slope;
      this->Intercept = intercept;
    }
    this->Parts = reader->GetQFac() > 0.0; // VTK turns the slices of a part wrongly
  }

  vtkSmartPointer<vtkDataArray> Read(const IndexBox& box) override
  {
    const vtkSmartPointer<vtkDataArray> values = VtkImageFile::Read(box);
    return this->Slope == 1.0 && this->Intercept == 0.0 ? values : this->Rescale(values);
  }

private:
  /// The matrices turn and move an image with VTK's order of slices and its spacing, which lies at 0.
  void SetPlace(vtkMatrix4x4* sform, vtkMatrix4x4* qform)
  {
    for (vtkMatrix4x4* matrix : { sform, qform })
    {
      std::array<Vector3, 3> steps{};
      for (int axis = 0; matrix && axis < 3; ++axis)
      {
        for (int c = 0; c < 3; ++c)
        {
          steps[axis][c] = matrix->GetElement(c, axis) * this->Where.Spacing[axis];
        }
      }
      if (AreAtRightAngles(steps))
      {
        SetSteps(steps, this->Where);
        this->Where.Origin = { { matrix->GetElement(0, 3), matrix->GetElement(1, 3),
          matrix->GetElement(2, 3) } };
        return;
      }
    }
    if (sform || qform)
    {
      throw InputError("its sform is sheared: the axes of the image are not at right angles, and "
                       "there is no qform. Resample the image onto a grid of right angles.");
    }
  }

  vtkSmartPointer<vtkDataArray> Rescale(vtkDataArray* stored) const
  {
    vtkNew<vtkDoubleArray> values;
    values->SetNumberOfTuples(stored->GetNumberOfTuples());
    for (vtkIdType i = 0; i < stored->GetNumberOfTuples(); ++i)
    {
      values->SetValue(i, this->Slope * stored->GetComponent(i, 0) + this->Intercept);
    }
    return values;
  }

  double Slope = 1.0, Intercept = 0.0;
};

} // namespace

std::unique_ptr<ImageFile> OpenNifti(const std::string& path)
{
  CheckHeader(path);
  vtkNew<vtkNIFTIImageReader> reader;
  return std::make_unique<NiftiFile>(path, reader);
}

} // namespace vfm
