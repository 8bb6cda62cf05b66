/**
 * @class   vtkVolumeFractionToHex
 * @brief   conforming hexahedral mesh of every material from cell-centred volume fractions
 *
 * The mesh follows the surfaces between the materials and the void, which it places by piecewise linear
 * interface calculation, and every hexahedron has a positive Jacobian at every corner, for any input.
 * Method: Owen, Staten, Sorensen, "Parallel hexahedral meshing from volume fractions", Engineering with
 * Computers 2014. See vtkVolumeFractionMeshAlgorithm for the input and the properties.
 *
 * Port 0, hexahedra of all materials. Cell arrays: MaterialId (int), FragmentId (int, face-connected
 * pieces from 1), GlobalCellIds, ScaledJacobian (float, verdict's, when ComputeQuality is on). Point
 * arrays: GlobalPointIds, GeometryDimension (int; 3 volume, 2 surface, 1 curve, 0 vertex), GeometryId
 * (int). Field data: MaterialNames, MaterialIds, TargetVolume, MeshVolume (length units cubed) of each
 * material, and counts and extremes of the run.
 *
 * Port 1, the quadrilaterals of all surfaces. Cell arrays: SurfaceId (int, from 1), MaterialPair (int,
 * 2 components, the smaller first, 0 void or outside; the normal points from the second to the first),
 * DomainSide (int, -1 inside, 0..5 for -x +x -y +y -z +z).
 */
#ifndef vtkVolumeFractionToHex_h
#define vtkVolumeFractionToHex_h

#include "vtkVolumeFractionMeshAlgorithm.h"
#include "vtkVolumeFractionMeshFiltersModule.h" // for export macro

class VTKVOLUMEFRACTIONMESHFILTERS_EXPORT vtkVolumeFractionToHex :
  public vtkVolumeFractionMeshAlgorithm
{
public:
  static vtkVolumeFractionToHex* New();
  vtkTypeMacro(vtkVolumeFractionToHex, vtkVolumeFractionMeshAlgorithm);

protected:
  vtkVolumeFractionToHex() = default;
  ~vtkVolumeFractionToHex() override = default;

  vfm::Mesh MakeMesh(const vfm::CartesianGrid& grid, const vfm::FractionField& fractions,
    const vfm::MeshOptions& options, vfm::Runtime& runtime, vfm::MeshReport& report) override;

private:
  vtkVolumeFractionToHex(const vtkVolumeFractionToHex&) = delete;
  void operator=(const vtkVolumeFractionToHex&) = delete;
};

#endif
