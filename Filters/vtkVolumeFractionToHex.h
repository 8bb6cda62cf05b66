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
 * material, and counts and extremes of the run; hidden from lists of arrays (vtkAbstractArray::GUI_HIDE).
 *
 * Port 1, the quadrilaterals of all surfaces. Cell arrays: SurfaceId (int, from 1), MaterialPair (int,
 * 2 components, the smaller first, 0 void or outside; the normal points from the second to the first),
 * DomainSide (int, -1 inside, 0..5 for -x +x -y +y -z +z).
 *
 * Port 2, the edges of all curves, lines of two points in the order of their curves. Cell array: CurveId (int, from 1).
 * Port 3, all vertices. Cell array: VertexId (int, from 1). Points of ports 1, 2 and 3: GlobalPointIds, those of the mesh.
 *
 * Field data of ports 1, 2 and 3, what bounds what (int, the same on every process). Of port 1: SurfaceVolumes, SurfaceMaterials
 * (2 components, a tuple a surface, as MaterialPair: fragments and materials on its sides, 0 not meshed or outside), SurfaceSides
 * (its DomainSide), VolumeSurfaces (2 components, a tuple each pair of a fragment and a surface around it). Of port 2: CurveEnds (a
 * value a curve: how many ends it has at vertices, 0 closed), SurfaceCurves (pairs). Of port 3: CurveVertices (pairs).
 *
 * Port 4, the materials: Name, MaterialId, TargetVolume, MeshVolume (length units cubed), VolumeError (relative), Elements, Fragments,
 * and MinimumScaledJacobian, MeanScaledJacobian when ComputeQuality is on.
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
  vtkVolumeFractionToHex();
  ~vtkVolumeFractionToHex() override = default;

private:
  vtkVolumeFractionToHex(const vtkVolumeFractionToHex&) = delete;
  void operator=(const vtkVolumeFractionToHex&) = delete;
};

#endif
