/**
 * @class   vtkVolumeFractionShapes
 * @brief   exact volume fractions of solid shapes on a uniform grid
 *
 * Makes an image with one cell array per material, Material1, Material2, ... (double), with the
 * volume fraction of the material in each cell. Shapes are inserted in order: the first keeps its
 * volume, and later ones get the rest of each cell, as in the material insertion of shock-physics
 * codes. Shapes come from a preset or from text, then from closed surfaces on the optional,
 * repeatable input port. Fractions of surfaces are exact; in a cell that boundaries of several
 * surfaces cut, overlaps are measured on rays. In a cell that boundaries of shapes and of a surface
 * cut, the surface gets its whole fraction if the rest of the cell allows it: an upper bound if the
 * boundaries cross there.
 *
 * Dimensions (cells) and Bounds (length units) define the grid. With FitToInput, the grid is
 * placed around the surfaces instead, with cubic cells and at least two cells of margin;
 * Dimensions is used.
 *
 * The surfaces themselves are field data of the output, which the mesh filters use: InputSurface..
 * (SurfaceFields.h).
 *
 * Any extent can be requested; fractions depend neither on the extent nor on threads. Each rank
 * needs the whole surfaces.
 *
 * Errors give one message and an empty output: invalid text, sizes that are not above 0, Dimensions
 * below 1, empty Bounds, a surface that is empty, open or not manifold, or no shape.
 */
#ifndef vtkVolumeFractionShapes_h
#define vtkVolumeFractionShapes_h

#include "vtkImageAlgorithm.h"
#include "vtkVolumeFractionMeshFiltersModule.h" // for export macro

#include <string> // for member

class VTKVOLUMEFRACTIONMESHFILTERS_EXPORT vtkVolumeFractionShapes : public vtkImageAlgorithm
{
public:
  static vtkVolumeFractionShapes* New();
  vtkTypeMacro(vtkVolumeFractionShapes, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Number of cells along x, y and z. Default 32 each.
   */
  vtkSetVector3Macro(Dimensions, int);
  vtkGetVector3Macro(Dimensions, int);
  ///@}

  ///@{
  /**
   * Domain: xmin, xmax, ymin, ymax, zmin, zmax. Default -1 to 1 each.
   */
  vtkSetVector6Macro(Bounds, double);
  vtkGetVector6Macro(Bounds, double);
  ///@}

  ///@{
  /**
   * Place the grid around the surfaces of the input instead of using Bounds. Default off.
   */
  vtkSetMacro(FitToInput, bool);
  vtkGetMacro(FitToInput, bool);
  vtkBooleanMacro(FitToInput, bool);
  ///@}

  ///@{
  /**
   * Number of a predefined scene; 0: none. Default 4, ball and plate. GetPresetName() returns the
   * names, and "" after the last.
   */
  vtkSetMacro(Preset, int);
  vtkGetMacro(Preset, int);
  static std::string GetPresetName(int preset);
  ///@}

  ///@{
  /**
   * Shapes as text, separated by lines or semicolons, such as `sphere material=1 center=0,0,0
   * radius=0.4`; see Shapes/ShapesText.h. Replaces the preset unless empty.
   */
  vtkSetStdStringFromCharMacro(Shapes);
  vtkGetCharFromStdStringMacro(Shapes);
  ///@}

  ///@{
  /**
   * Material of the surfaces of the input. Default 0: each gets the next free number.
   */
  vtkSetMacro(SurfaceMaterial, int);
  vtkGetMacro(SurfaceMaterial, int);
  ///@}

  ///@{
  /**
   * Maximum error of a fraction where curved shapes cut a cell, between 0 and 1. Default 1e-4.
   */
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /**
   * Number of threads. Default 0: all cores on one rank, one thread per rank on several.
   */
  vtkSetClampMacro(NumberOfThreads, int, 0, VTK_INT_MAX);
  vtkGetMacro(NumberOfThreads, int);
  ///@}

protected:
  vtkVolumeFractionShapes();
  ~vtkVolumeFractionShapes() override = default;

  vtkExecutive* CreateDefaultExecutive() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(
    vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* output) override;
  int RequestUpdateExtent(
    vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*) override;
  int RequestData(
    vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* output) override;

  int Dimensions[3] = { 32, 32, 32 };
  double Bounds[6] = { -1.0, 1.0, -1.0, 1.0, -1.0, 1.0 };
  bool FitToInput = false;
  int Preset = 4;
  std::string Shapes;
  int SurfaceMaterial = 0;
  double Tolerance = 1e-4;
  int NumberOfThreads = 0;

private:
  vtkVolumeFractionShapes(const vtkVolumeFractionShapes&) = delete;
  void operator=(const vtkVolumeFractionShapes&) = delete;

  std::string FindGridError() const;
  void Fill(vtkInformationVector* surfaces, const int extent[6], vtkImageData* image);
};

#endif
