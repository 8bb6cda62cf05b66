/**
 * @class   vtkVolumeFractionVoxelReader
 * @brief   reads images of one value a cell: text of Sculpt (.spn) and NumPy arrays (.npy)
 *
 * Output: an image with the integer cell array 'MaterialId', 0 for void, for vtkVolumeFractionToHex::SetMaterialIdArray. Of a NumPy
 * array of reals: 'VolumeFraction', or of a 4-D array, material first, 'VolumeFraction1', 'VolumeFraction2', ...
 *
 * A .spn file is a text of whole numbers with any white space between them, a cell each; it needs Dimensions. A .npy file is a
 * 3-D array of bool or of whole numbers or reals in either byte order, C or Fortran order, versions 1 to 3, and tells its own.
 * A file is taken for NumPy's by its suffix.
 *
 * Any extent can be asked for and only that is kept. Under MPI every process of the Controller opens the file and all must update
 * together. Text, and NumPy types that can hold negative or too large labels, are read to the end by every process; of other
 * types only what it needs.
 *
 * Errors (one message on all processes alike, empty output, failure): the file cannot be read, has too few or too many values,
 * values that are no whole numbers, negative or over 2^31 - 1, is no NumPy file, or of a type or shape that is no image; no
 * Dimensions for text; Spacing not above 0.
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
   * Cells along x, y and z of a text: nelx, nely and nelz of Sculpt. Default 0, not told; NumPy files tell their own.
   */
  vtkSetVector3Macro(Dimensions, int);
  vtkGetVector3Macro(Dimensions, int);
  ///@}

  ///@{
  /**
   * The lower corner of the first cell. Default 0.
   */
  vtkSetVector3Macro(Origin, double);
  vtkGetVector3Macro(Origin, double);
  ///@}

  ///@{
  /**
   * Edges of a cell, above 0. Default 1.
   */
  vtkSetVector3Macro(Spacing, double);
  vtkGetVector3Macro(Spacing, double);
  ///@}

  /**
   * Orders of the axes, with the numbers of Sculpt's spn_xyz_order.
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
   * The axes as the indices of an array name them: XYZ is a[x][y][z]. In a text, the last axis changes fastest from value to value.
   * Default XYZ, as Sculpt reads text without spn_xyz_order and automesh NumPy files; automesh's text is ZYX.
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
