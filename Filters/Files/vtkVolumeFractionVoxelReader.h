/**
 * @class   vtkVolumeFractionVoxelReader
 * @brief   reads images of one value per cell: text of Sculpt (.spn) and NumPy arrays (.npy)
 *
 * Output: an image with the integer cell array 'MaterialId', 0 for void, for
 * vtkVolumeFractionToHex::SetMaterialIdArray. NumPy arrays of reals give 'VolumeFraction'; 4-D
 * arrays, material first, give 'VolumeFraction1', 'VolumeFraction2', ...
 *
 * A .spn file is a text with one integer per cell, separated by white space; set Dimensions. A .npy
 * file is a 3-D array of bool, integers or reals, in any byte order, C or Fortran order, versions 1
 * to 3; it has dimensions. The suffix determines the format.
 *
 * Any extent can be requested, and only that is stored. All ranks of the Controller open the file
 * and must update together. Each rank reads the whole file if it is text, or if the NumPy type can
 * hold negative or too large labels; otherwise each rank reads only its part.
 *
 * Errors give one message, the same on all ranks, and empty outputs:
 * - the file cannot be read, is not a NumPy file, or has a type or shape that is not an image;
 * - there are too few or too many values, or labels that are not integers from 0 to 2^31 - 1;
 * - Dimensions are not set for text, or Spacing is not above 0.
 */
#ifndef vtkVolumeFractionVoxelReader_h
#define vtkVolumeFractionVoxelReader_h

#include "vtkVolumeFractionMeshIOModule.h" // for export macro
#include "vtkVolumeFractionPartReader.h"

class VTKVOLUMEFRACTIONMESHIO_EXPORT vtkVolumeFractionVoxelReader :
  public vtkVolumeFractionPartReader
{
public:
  static vtkVolumeFractionVoxelReader* New();
  vtkTypeMacro(vtkVolumeFractionVoxelReader, vtkVolumeFractionPartReader);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Number of cells of a text along x, y and z: nelx, nely and nelz of Sculpt. Default 0: not set.
   * Not used for NumPy files.
   */
  vtkSetVector3Macro(Dimensions, int);
  vtkGetVector3Macro(Dimensions, int);
  ///@}

  ///@{
  /**
   * Lower corner of the first cell. Default 0.
   */
  vtkSetVector3Macro(Origin, double);
  vtkGetVector3Macro(Origin, double);
  ///@}

  ///@{
  /**
   * Size of a cell, above 0. Default 1.
   */
  vtkSetVector3Macro(Spacing, double);
  vtkGetVector3Macro(Spacing, double);
  ///@}

  /**
   * Orders of the axes, with the numbers of Sculpt's option spn_xyz_order.
   */
  enum AxisOrderType
  {
    AXIS_ORDER_XYZ = 0,
    AXIS_ORDER_XZY,
    AXIS_ORDER_YXZ,
    AXIS_ORDER_YZX,
    AXIS_ORDER_ZXY,
    AXIS_ORDER_ZYX
  };

  ///@{
  /**
   * Order of the axes in the indices of an array: XYZ is a[x][y][z]. In a text, the last axis
   * changes fastest. Default XYZ, as in Sculpt without spn_xyz_order, and in NumPy files of
   * automesh. Text of automesh is ZYX.
   */
  vtkSetClampMacro(AxisOrder, int, AXIS_ORDER_XYZ, AXIS_ORDER_ZYX);
  vtkGetMacro(AxisOrder, int);
  ///@}

protected:
  vtkVolumeFractionVoxelReader() = default;
  ~vtkVolumeFractionVoxelReader() override = default;

  vfm::ImageSource Open() override;

  int Dimensions[3] = { 0, 0, 0 };
  double Origin[3] = { 0.0, 0.0, 0.0 };
  double Spacing[3] = { 1.0, 1.0, 1.0 };
  int AxisOrder = AXIS_ORDER_XYZ;

private:
  vtkVolumeFractionVoxelReader(const vtkVolumeFractionVoxelReader&) = delete;
  void operator=(const vtkVolumeFractionVoxelReader&) = delete;
};

#endif
