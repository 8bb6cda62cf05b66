/**
 * VtkImageFile: an image that one of VTK's readers reads.
 */
#pragma once

#include "Images/ImageFile.h"

class vtkImageReader2;

namespace vfm
{

class VtkImageFile : public ImageFile
{
public:
  /// Size, spacing and origin are the reader's. Throws InputError when it fails, and on an image of several values a point.
  VtkImageFile(const std::string& path, vtkSmartPointer<vtkImageReader2> reader);

  vtkSmartPointer<vtkDataArray> Read(const IndexBox& box) override;

protected:
  /// Of the values of the whole image.
  double CountBytes() const;

private:
  vtkSmartPointer<vtkImageReader2> Reader;
};

} // namespace vfm
