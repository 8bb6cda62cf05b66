/**
 * @class   vtkVolumeFractionImageReader
 * @brief   reads images of labels or volume fractions (NIfTI, MGH, NRRD, MetaImage, TIFF, PNG,
 *          DREAM.3D), and slices in several files
 *
 * Output: an image with the spacing, origin and direction matrix of the file, and one point array;
 * points are the centres of voxels. The array is 'Labels' for integers, else 'Values'. From
 * .dream3d files, the cell array CellArray is read. The suffix determines the format. FileName may
 * also be a folder of slices, or a pattern such as slices/a*.tif. Names of labels that the file
 * contains are in the field data arrays NamedLabels and LabelNames, which the mesh filters use.
 *
 * | file | position of the image | notes |
 * | .nii .nii.gz | sform; else qform; else spacing; RAS, mostly mm | scaled by slope, intercept |
 * | .mgz .mgh | spacing, direction cosines and centre; RAS, mm | |
 * | .nrrd .nhdr | space directions and origin, else spacings; mostly LPS | raw and gzip |
 * | .mha .mhd | Offset, TransformMatrix, ElementSpacing; mostly LPS | |
 * | .tif .tiff | ImageJ, OME; else resolution as mm, z as x: set Spacing | pages are slices |
 * | .png | 0, spacing 1 | one layer; grey values, palette indices or colours as labels |
 * | .dream3d | origin and spacing of the image geometry | DREAM.3D 6, DREAM3D-NX |
 *
 * A missing or sheared sform of NIfTI is not used. Coordinates are not converted between RAS and
 * LPS. The order of the slices of left-handed NIfTI images is reversed.
 *
 * Any extent can be requested. All ranks of the Controller open the file and must update together.
 * Each rank reads its part of DREAM.3D files, its slices of TIFF files and of files of slices, and
 * its part of uncompressed NIfTI, MetaImage and NRRD files. Rank 0 reads other files and sends the
 * parts.
 *
 * Errors give one message, the same on all ranks, and empty outputs: the file cannot be read, is
 * damaged, has several values per point or several images, or axes that are not orthogonal.
 */
#ifndef vtkVolumeFractionImageReader_h
#define vtkVolumeFractionImageReader_h

#include "vtkVolumeFractionMeshIOModule.h" // for export macro
#include "vtkVolumeFractionPartReader.h"

#include <string> // for member
#include <vector> // for member

class VTKVOLUMEFRACTIONMESHIO_EXPORT vtkVolumeFractionImageReader :
  public vtkVolumeFractionPartReader
{
public:
  static vtkVolumeFractionImageReader* New();
  vtkTypeMacro(vtkVolumeFractionImageReader, vtkVolumeFractionPartReader);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Size of a voxel, length units; replaces the spacing of the file. Default 0: spacing of
   * the file.
   */
  vtkSetVector3Macro(Spacing, double);
  vtkGetVector3Macro(Spacing, double);
  ///@}

  ///@{
  /**
   * Cell array to read from .dream3d files, by its name or the end of its path. Default FeatureIds.
   */
  vtkSetStdStringFromCharMacro(CellArray);
  vtkGetCharFromStdStringMacro(CellArray);
  ///@}

  ///@{
  /**
   * Number of the image to read, from 0, in a file that holds several. Default -1: the only image.
   */
  vtkSetMacro(Volume, int);
  vtkGetMacro(Volume, int);
  ///@}

  ///@{
  /**
   * Files of one slice each (TIFF, PNG), which form one image in natural order of their names.
   * A single slice is used as FileName. None: FileName.
   */
  void AddSlice(const char* path);
  void RemoveAllSlices();
  ///@}

  ///@{
  /**
   * Whether the header may name files outside of its folder, and lines and compression ratios are
   * not limited. Default off.
   */
  vtkSetMacro(TrustInput, bool);
  vtkGetMacro(TrustInput, bool);
  vtkBooleanMacro(TrustInput, bool);
  ///@}

protected:
  vtkVolumeFractionImageReader() = default;
  ~vtkVolumeFractionImageReader() override = default;

  vfm::ImageSource Open() override;

  double Spacing[3] = { 0.0, 0.0, 0.0 };
  std::string CellArray = "FeatureIds";
  int Volume = -1;
  std::vector<std::string> Slices;
  bool TrustInput = false;

private:
  vtkVolumeFractionImageReader(const vtkVolumeFractionImageReader&) = delete;
  void operator=(const vtkVolumeFractionImageReader&) = delete;
};

#endif
