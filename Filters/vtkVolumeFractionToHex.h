/**
 * @class   vtkVolumeFractionToHex
 * @brief   conforming hexahedral mesh of every material from cell-centred volume fractions
 *
 * The mesh follows the surfaces between the materials and the void, which are placed by
 * piecewise linear interface calculation. Every hexahedron has a positive Jacobian at every
 * corner, for any input. Method: Owen, Staten and Sorensen, "Parallel hexahedral meshing from
 * volume fractions", Engineering with Computers, 2014. See vtkVolumeFractionMeshAlgorithm for
 * the input and the properties.
 *
 * Port 0, hexahedra of all materials.
 * - Cell arrays: MaterialId (int), FragmentId (int, from 1), GlobalCellIds; ScaledJacobian (float,
 *   as defined by verdict) if ComputeQuality is on
 * - Point arrays: GlobalPointIds, GeometryDimension (int; 3 volume, 2 surface, 1 curve, 0 vertex),
 *   GeometryId (int)
 * - Field data, hidden from lists of arrays (vtkAbstractArray::GUI_HIDE): MaterialNames,
 *   MaterialIds, TargetVolume, MeshVolume (length units cubed) of each material; counts and
 *   extremes of the run
 *
 * Port 1, quadrilaterals of all surfaces.
 * - Cell arrays: SurfaceId (int, from 1); MaterialPair (int, 2 components, the smaller first, 0
 *   void or outside; the normal points from the second to the first); DomainSide (int, -1 inside,
 *   0..5 for -x +x -y +y -z +z)
 * - Field data: SurfaceVolumes, SurfaceMaterials (2 components per surface: fragments and materials
 *   on its sides as in MaterialPair, 0 not meshed or outside); SurfaceSides (its DomainSide);
 *   VolumeSurfaces (pairs of a fragment and a surface around it)
 *
 * Port 2, edges of all curves, lines of two points ordered by curve.
 * - Cell array: CurveId (int, from 1)
 * - Field data: CurveEnds (number of ends of each curve at vertices, 0 closed); SurfaceCurves
 *   (pairs)
 *
 * Port 3, all vertices.
 * - Cell array: VertexId (int, from 1)
 * - Field data: CurveVertices (pairs)
 *
 * Ports 1, 2 and 3 have the point array GlobalPointIds of the mesh. Their field data is of type int
 * and equal on all ranks; without WholeTables, ranks have their rows, numbered by SurfaceIds and
 * CurveIds.
 *
 * Port 4, one row per material: Name, MaterialId, TargetVolume, MeshVolume (length units cubed),
 * VolumeError (relative), LostCells, GainedCells (cells that changed their material), Elements,
 * Fragments; MinimumScaledJacobian and MeanScaledJacobian if ComputeQuality is on.
 *
 * Port 5, vtkUnstructuredGrid: hexahedra of zero thickness between the sides of split interfaces,
 * if SplitConnection is Cohesive; cell arrays MaterialPair, GlobalCellIds, point array
 * GlobalPointIds of the mesh.
 *
 * Port 6, vtkPolyData: material without elements as particles, a vertex each, if UnmeshedMaterial
 * is Particles; point arrays Id, Material, Radius, Volume, Mass (with a density) and state arrays.
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
