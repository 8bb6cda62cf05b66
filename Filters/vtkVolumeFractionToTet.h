/**
 * @class   vtkVolumeFractionToTet
 * @brief   conforming tetrahedral mesh of every material from cell-centred volume fractions
 *
 * The mesh follows the surfaces between the materials and the void, and every tetrahedron has a
 * positive volume, for any input. Methods:
 * - METHOD_LATTICE: a body-centred cubic lattice of labelled cell centres and grid nodes. It is cut
 *   where labels differ, and points are snapped where a cut would be too near. This method gives
 *   the best angles and the closest fit to the surface.
 * - METHOD_CELLS: each cell is cut into tetrahedra around its centre. The surfaces have the faces
 *   and labels of vtkVolumeFractionToHex, with each quadrilateral split into two triangles.
 * - METHOD_TETGEN: TetGen fills the smoothed surfaces of METHOD_CELLS with tetrahedra that grow
 *   away from the surfaces (Si, "TetGen, a Delaunay-based quality tetrahedral mesh generator", ACM
 *   Transactions on Mathematical Software 41, 2015). Parts that TetGen rejects keep the tetrahedra
 *   of METHOD_CELLS, with a warning. Requires a build with TetGen (HasTetGen()), which has the GNU
 *   Affero General Public License.
 *
 * With METHOD_CELLS and METHOD_LATTICE, the mesh is bitwise identical on any number of ranks. With
 * METHOD_TETGEN, only the surfaces are; the tetrahedra between them depend on the partition.
 *
 * See vtkVolumeFractionMeshAlgorithm for the input and the properties. TargetScaledJacobian is the
 * target for the sine of the acute dihedral angles: 0.5 is 30 degrees, 0 means slightly above 0.5.
 * FineInterfaces has no effect: all interfaces get the finest cells.
 *
 * Port 0, tetrahedra of all materials, with the arrays of vtkVolumeFractionToHex. Additional field
 * data: RefusedParts (vtkIdType); if ComputeQuality is on, MinimumDihedralAngle,
 * MaximumDihedralAngle (double, degrees) and DihedralAngles (vtkIdType, histogram of 18 intervals
 * of ten degrees).
 *
 * Port 1 has the triangles of all surfaces, port 2 the edges of all curves, port 3 all vertices,
 * port 4 the materials, port 5 the cohesive elements and port 6 the particles, with the arrays of
 * vtkVolumeFractionToHex.
 */
#ifndef vtkVolumeFractionToTet_h
#define vtkVolumeFractionToTet_h

#include "vtkVolumeFractionMeshAlgorithm.h"
#include "vtkVolumeFractionMeshFiltersModule.h" // for export macro

class VTKVOLUMEFRACTIONMESHFILTERS_EXPORT vtkVolumeFractionToTet :
  public vtkVolumeFractionMeshAlgorithm
{
public:
  static vtkVolumeFractionToTet* New();
  vtkTypeMacro(vtkVolumeFractionToTet, vtkVolumeFractionMeshAlgorithm);

  enum MethodType
  {
    METHOD_TETGEN = 0,
    METHOD_CELLS = 1,
    METHOD_LATTICE = 2
  };

  /**
   * Returns whether TetGen was built in; otherwise METHOD_TETGEN is an error.
   */
  static bool HasTetGen();

  // options: generated
  /// How the tetrahedra are made. Lattice: a lattice of cell centres and grid nodes is cut along
  /// the surfaces, which gives the best angles and the closest fit. Cells: each cell is cut into
  /// tetrahedra around its centre, so that the surfaces have the faces and labels of Volume
  /// Fraction To Hex. TetGen: TetGen fills the surfaces of Cells with tetrahedra that grow away
  /// from them, which gives the fewest tetrahedra. TetGen is an optional part of the build.
  /// Allowed: TetGen, Cells, Lattice (or 0 to 2); default Lattice.
  vfmNumberOption(Method, int);
  /// Target length of the edges next to the surfaces, in cells of the grid. The triangles of the
  /// surfaces do not change. Allowed: a number from 0.1 to 1e6; default 1.
  vfmNumberOption(RelativeSize, double);
  /// Increase of the edge length per cell of distance from the surfaces. 0: edges are equally short
  /// everywhere. Allowed: a number from 0 to 1e6; default 0.3.
  vfmNumberOption(Growth, double);
  /// Maximum ratio of the circumradius of a tetrahedron to its shortest edge. Smaller values give
  /// more and better tetrahedra. Allowed: a number from 1 to 100; default 1.4.
  vfmNumberOption(RadiusEdgeRatio, double);
  /// Target of refinement for the smallest dihedral angle, in degrees. Allowed: a number from 0 to
  /// 60; default 10.
  vfmNumberOption(MinimumDihedralAngle, double);
  /// How much TetGen improves the tetrahedra by flips and smoothing. Allowed: an integer from 0 to
  /// 10; default 4.
  vfmNumberOption(OptimizationLevel, int);
  // end of options

protected:
  vtkVolumeFractionToTet();
  ~vtkVolumeFractionToTet() override = default;

private:
  vtkVolumeFractionToTet(const vtkVolumeFractionToTet&) = delete;
  void operator=(const vtkVolumeFractionToTet&) = delete;
};

#endif
