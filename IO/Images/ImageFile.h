/**
 * ImageFile: a file of one image, one value a point or a cell, in any of the formats that images of labels come in.
 */
#pragma once

#include "Images/ImagePlace.h"

#include "vtkSmartPointer.h"

#include <memory>
#include <string>
#include <vector>

class vtkDataArray;

namespace vfm
{

/// What it throws is InputError without the path. Nothing here communicates.
class ImageFile
{
public:
  virtual ~ImageFile() = default;

  const ImagePlace& Place() const { return this->Where; }
  /// Instead of the file's.
  void SetSpacing(const Vector3& spacing) { this->Where.Spacing = spacing; }
  /// Values are those of cells, and the origin is the corner of the first; else of points.
  bool IsOfCells() const { return this->OfCells; }
  /// False where the whole image must be read to have a part of it.
  bool ReadsParts() const { return this->Parts; }

  /// The values in a box of the image, x fastest, without a name. Anew each time: nothing is kept.
  virtual vtkSmartPointer<vtkDataArray> Read(const IndexBox& box) = 0;

protected:
  ImagePlace Where;
  bool OfCells = false, Parts = false;
};

/// By the end of its name. array: of a .dream3d file, the name of a cell array, or the end of its path.
std::unique_ptr<ImageFile> OpenImageFile(const std::string& path, const std::string& array);

/// Such as ".nii".
const std::vector<std::string>& GetImageSuffixes();
bool IsImageFile(const std::string& path);

///@{ NIfTI-1 and -2: millimetres, x to the right, y to the front, z up (RAS). The sform tells the place, or where there is none or it
/// is sheared, the qform, or the spacing alone. VTK turns the order of slices of left-handed ones.
std::unique_ptr<ImageFile> OpenNifti(const std::string& path);
/// NRRD: space directions and space origin, or spacings, in the space that the file names (mostly LPS). Raw and gzip.
std::unique_ptr<ImageFile> OpenNrrd(const std::string& path);
/// MetaImage: Offset, ElementSpacing and TransformMatrix, the coordinates of the file (mostly LPS).
std::unique_ptr<ImageFile> OpenMetaImage(const std::string& path);
/// TIFF: a page is a slice, x to the right, y up, z from page to page. Resolution gives x and y in millimetres; z as x.
std::unique_ptr<ImageFile> OpenTiff(const std::string& path);
/// DREAM.3D 6 and DREAM3D-NX: the cell array of an image geometry.
std::unique_ptr<ImageFile> OpenDream3d(const std::string& path, const std::string& array);
///@}

} // namespace vfm
