#include "Base/Errors.h"
#include "Base/Vector3.h"
#include "ImageFile.h"
#include "VtkImageFile.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkMatrix4x4.h"
#include "vtkNIFTIImageReader.h"
#include "vtkNew.h"

namespace vfm
{
namespace
{

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
    const double slope = reader->GetRescaleSlope();
    this->Slope = slope == 0.0 ? 1.0 : slope; // 0: values are as they are
    this->Intercept = slope == 0.0 ? 0.0 : reader->GetRescaleIntercept();
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
  vtkNew<vtkNIFTIImageReader> reader;
  return std::make_unique<NiftiFile>(path, reader);
}

} // namespace vfm
