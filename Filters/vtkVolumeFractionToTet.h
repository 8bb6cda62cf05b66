/**
 * @class   vtkVolumeFractionToTet
 * @brief   conforming tetrahedral mesh of every material from cell-centred volume fractions
 *
 * The mesh follows the surfaces between the materials and the void, and every tetrahedron has a positive volume,
 * for any input. Three methods:
 * - METHOD_LATTICE: a body-centred cubic lattice of cell centres and grid nodes, each with a label of its own, cut
 *   where labels differ and snapped where a cut would come too near. The best angles, and the nearest to the surface.
 * - METHOD_CELLS: every cell is cut into tetrahedra around its centre, so the surfaces have the faces and labels of
 *   vtkVolumeFractionToHex, each quadrilateral in two triangles.
 * - METHOD_TETGEN: the smoothed surfaces of METHOD_CELLS, filled by TetGen (Si, "TetGen, a Delaunay-based quality
 *   tetrahedral mesh generator", ACM Transactions on Mathematical Software 2015) with tetrahedra that grow
 *   away from the surfaces. Parts that TetGen refuses keep the tetrahedra of METHOD_CELLS, with a warning. Only
 *   where TetGen was built in (HasTetGen()); that library is under the GNU Affero General Public License.
 *
 * The same mesh, bit for bit, on any number of processes: METHOD_CELLS and METHOD_LATTICE. With METHOD_TETGEN the
 * surfaces are the same, the tetrahedra between them follow the partition.
 *
 * See vtkVolumeFractionMeshAlgorithm for the input and the properties. TargetScaledJacobian is here the sine of
 * the acute dihedral angles that smoothing strives for: .5 is 30 degrees; 0: a little more than .5. FineInterfaces has
 * no effect: all interfaces get the finest cells.
 *
 * Port 0, tetrahedra of all materials, with the arrays of vtkVolumeFractionToHex. Field data also:
 * MinimumDihedralAngle, MaximumDihedralAngle (double, degrees) and DihedralAngles (vtkIdType, 18 values: how many
 * angles lie in each ten degrees) when ComputeQuality is on, RefusedParts (vtkIdType).
 *
 * Port 1, the triangles of all surfaces; port 2, the edges of all curves; port 3, all vertices: with the arrays of
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
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum MethodType
  {
    METHOD_TETGEN = 0,
    METHOD_CELLS = 1,
    METHOD_LATTICE = 2
  };

  ///@{
  /**
   * How the tetrahedra are made. Default: METHOD_TETGEN where it was built in, else METHOD_LATTICE.
   */
  vtkSetClampMacro(Method, int, METHOD_TETGEN, METHOD_LATTICE);
  vtkGetMacro(Method, int);
  ///@}

  /**
   * Whether METHOD_TETGEN was built in; an error where it is asked for and was not.
   */
  static bool HasTetGen();

  ///@{
  /**
   * METHOD_TETGEN: wished length of the edges beside the surfaces, in cells; at least 0.1. The triangles of the
   * surfaces stay as they are. Default: 1.
   */
  vtkSetMacro(RelativeSize, double);
  vtkGetMacro(RelativeSize, double);
  ///@}

  ///@{
  /**
   * METHOD_TETGEN: by how much that length grows over each cell of distance from the surfaces; at least 0.
   * Default: 0.3.
   */
  vtkSetMacro(Growth, double);
  vtkGetMacro(Growth, double);
  ///@}

  ///@{
  /**
   * METHOD_TETGEN: largest ratio of circumradius to shortest edge of a tetrahedron; at least 1. Default: 1.4.
   */
  vtkSetMacro(RadiusEdgeRatio, double);
  vtkGetMacro(RadiusEdgeRatio, double);
  ///@}

  ///@{
  /**
   * METHOD_TETGEN: the dihedral angle that refinement strives for; 0 to 60 degrees. Default: 10.
   */
  vtkSetMacro(MinimumDihedralAngle, double);
  vtkGetMacro(MinimumDihedralAngle, double);
  ///@}

  ///@{
  /**
   * METHOD_TETGEN: how much it flips and smooths; 0 to 10. Default: 4.
   */
  vtkSetMacro(OptimizationLevel, int);
  vtkGetMacro(OptimizationLevel, int);
  ///@}

protected:
  vtkVolumeFractionToTet();
  ~vtkVolumeFractionToTet() override = default;

  void SpecialiseOptions(vfm::MesherOptions& options) const override;

  int Method;
  double RelativeSize = 1.0;
  double Growth = 0.3;
  double RadiusEdgeRatio = 1.4;
  double MinimumDihedralAngle = 10.0;
  int OptimizationLevel = 4;

private:
  vtkVolumeFractionToTet(const vtkVolumeFractionToTet&) = delete;
  void operator=(const vtkVolumeFractionToTet&) = delete;
};

#endif
