/**
 * @class   vtkVolumeFractionShapes
 * @brief   exact volume fractions of solid shapes on a uniform grid
 *
 * Makes an image with one cell array a material, Material1, Material2, ... (double), which holds
 * the part of each cell that the material fills. Shapes are inserted in order: the first keeps its
 * volume, later ones get what is left of each cell, as in the material insertion of shock-physics
 * codes. The shapes come from a preset or from text, then from the closed surfaces on the optional,
 * repeatable input port.
 *
 * The grid is given by Dimensions (cells) and Bounds (length units). With FitToInput the grid is
 * instead put around the surfaces, with cubic cells and at least two cells of margin; Dimensions
 * stays as given.
 *
 * Any extent can be asked for; a cell's fractions depend on neither the extent nor the threads. The
 * surfaces are wanted whole on every process.
 *
 * Errors (one message, empty output, failure): text that is no shape, sizes not above 0, Dimensions
 * below 1, empty Bounds, a surface that is empty, open or not manifold, no shape at all.
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
   * Cells along x, y and z. Default 32 each.
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
   * Put the grid around the surfaces of the input instead of using Bounds. Default off.
   */
  vtkSetMacro(FitToInput, bool);
  vtkGetMacro(FitToInput, bool);
  vtkBooleanMacro(FitToInput, bool);
  ///@}

  ///@{
  /**
   * A ready scene, by number; 0 for none. Default 4, ball and plate. GetPresetName() tells the
   * scenes, and is empty past the last.
   */
  vtkSetMacro(Preset, int);
  vtkGetMacro(Preset, int);
  static std::string GetPresetName(int preset);
  ///@}

  ///@{
  /**
   * Shapes as text, one a line or parted by semicolons, such as `sphere material=1 center=0,0,0
   * radius=0.4`; Shapes/ShapesText.h tells all. Replaces the preset when not empty.
   */
  vtkSetStdStringFromCharMacro(Shapes);
  vtkGetCharFromStdStringMacro(Shapes);
  ///@}

  ///@{
  /**
   * Material of the surfaces of the input. Default 0: each gets the next number that is free.
   */
  vtkSetMacro(SurfaceMaterial, int);
  vtkGetMacro(SurfaceMaterial, int);
  ///@}

  ///@{
  /**
   * Largest error of a fraction where curved surfaces cut a cell; between 0 and 1. Default 1e-4.
   */
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /**
   * Threads; default 0: all cores on one process, one thread on each of several.
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
