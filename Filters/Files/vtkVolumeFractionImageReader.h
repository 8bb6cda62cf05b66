/**
 * @class   vtkVolumeFractionImageReader
 * @brief   reads images of labels or volume fractions: NIfTI, NRRD, MetaImage, TIFF stacks, DREAM.3D
 *
 * Output: an image with spacing, origin and direction matrix of the file, and one array: 'Labels' of whole numbers, else 'Values',
 * at the points, each the centre of a voxel; of .dream3d the cell array that CellArray names. The suffix tells the format.
 *
 * | file | where the image lies | |
 * | .nii .nii.gz | sform, else (none, or sheared) qform, else spacing alone; RAS, mostly mm | scaled by slope and intercept |
 * | .nrrd .nhdr | space directions and origin, else spacings; the file's space, mostly LPS | raw and gzip |
 * | .mha .mhd | Offset, TransformMatrix, ElementSpacing; mostly LPS | |
 * | .tif .tiff | resolution as mm, z as x: set Spacing | pages are slices; x to the right, y up |
 * | .dream3d | origin and spacing of the image geometry | DREAM.3D 6, DREAM3D-NX |
 *
 * Coordinates stay those of the file. Slices of left-handed NIfTI images are turned about.
 *
 * Any extent can be asked for. Under MPI every process of the Controller opens the file and all must update together. NIfTI,
 * MetaImage and NRRD that are not compressed, and DREAM.3D are read by every process in its part; of others the first process reads the whole and
 * sends parts.
 *
 * Errors (one message on all processes alike, empty output): the file cannot be read, is damaged, has several values a
 * point, several images, axes that are not at right angles.
 */
#ifndef vtkVolumeFractionImageReader_h
#define vtkVolumeFractionImageReader_h

#include "vtkVolumeFractionMeshIOModule.h" // for export macro
#include "vtkVolumeFractionPartReader.h"

#include <string> // for member

class VTKVOLUMEFRACTIONMESHIO_EXPORT vtkVolumeFractionImageReader :
  public vtkVolumeFractionPartReader
{
public:
  static vtkVolumeFractionImageReader* New();
  vtkTypeMacro(vtkVolumeFractionImageReader, vtkVolumeFractionPartReader);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The edges of a voxel, instead of those that the file tells. Default 0: the file's.
   */
  vtkSetVector3Macro(Spacing, double);
  vtkGetVector3Macro(Spacing, double);
  ///@}

  ///@{
  /**
   * Of .dream3d: the cell array to read, by its name or the end of its path. Default FeatureIds.
   */
  vtkSetStdStringFromCharMacro(CellArray);
  vtkGetCharFromStdStringMacro(CellArray);
  ///@}

protected:
  vtkVolumeFractionImageReader() = default;
  ~vtkVolumeFractionImageReader() override = default;

  vfm::ImageSource Open() override;

  double Spacing[3] = { 0.0, 0.0, 0.0 };
  std::string CellArray = "FeatureIds";

private:
  vtkVolumeFractionImageReader(const vtkVolumeFractionImageReader&) = delete;
  void operator=(const vtkVolumeFractionImageReader&) = delete;
};

#endif
