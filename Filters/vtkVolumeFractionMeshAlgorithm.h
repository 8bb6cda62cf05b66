/**
 * @class   vtkVolumeFractionMeshAlgorithm
 * @brief   base of the filters from cell-centred volume fractions to finite-element meshes
 *
 * **Grids.** Input is one of:
 * - vtkImageData, vtkUniformGrid or vtkRectilinearGrid;
 * - vtkUnstructuredGrid or vtkStructuredGrid whose cells form a Cartesian grid: hexahedra or voxels
 *   with sides along the axes, in any order, as in Exodus files;
 * - a composite data set of these whose blocks tile one grid, or the levels of a refined grid:
 *   vtkOverlappingAMR, vtkNonOverlappingAMR, or any other with cells 2, 4, 8 .. times as wide as
 *   the finest. Coarser data below finer blocks are ignored.
 *
 * Cells of less than three dimensions and ghost cells (vtkGhostType) are ignored. Blanked cells
 * are void. Images with a direction matrix, which must be orthonormal, are meshed in image axes;
 * then the mesh is rotated. Sides and bounds of the domain are in image axes. State arrays are
 * not rotated.
 *
 * **Materials.** They come from cell arrays, or from point arrays of images of one level, whose
 * points are then the centres of cells:
 * - one volume fraction array per material (AddVolumeFractionArray), of any numeric type, with
 *   values in [0,1], or 0..255 if unsigned char. Material i is the i-th array, counted from 1; the
 *   rest of a cell is void; or
 * - one array of integers (MaterialIdArray) with the material of each cell, 0 for void.
 *
 * **Ranks.** The input may have any distribution over the ranks of the Controller; ranks may be
 * empty. Cells are redistributed, one box per rank, unless they already are distributed so. All
 * ranks must update together. The mesh, its ids and its field data do not depend on the number of
 * ranks. Each rank gets the elements of its cells; points between ranks are on each with equal
 * GlobalPointIds. A run on several ranks cannot be aborted.
 *
 * **Outputs.** Port 0: the mesh, vtkUnstructuredGrid. Ports 1, 2 and 3, vtkPolyData: its surfaces,
 * the curves where surfaces meet, and the vertices where curves meet or end. Each facet, edge and
 * vertex is on one rank; their ids and the tables of their relations are equal on all ranks. Port
 * 4: vtkTable with one row per material, only on rank 0.
 *
 * **Errors.** Input that cannot be meshed, on any rank, gives one error message and empty outputs
 * on all ranks, with the message in the field data MeshError. Input that failed does the same. The
 * update itself does not fail (Parallel/Vtk/FailedOutput.h has the reason).
 */
#ifndef vtkVolumeFractionMeshAlgorithm_h
#define vtkVolumeFractionMeshAlgorithm_h

#include "ChosenArray.h" // for member
#include "vtkVolumeFractionFilter.h"

#include <string> // for member
#include <vector> // for member

namespace vfm
{
class MessageRanks;
class Ranks;
struct MaterialArrays;
struct MeshOutputs;
struct StateChoice;
enum class ElementKind;
} // namespace vfm

class VTKVOLUMEFRACTIONMESHFILTERS_EXPORT vtkVolumeFractionMeshAlgorithm :
  public vtkVolumeFractionFilter
{
public:
  vtkTypeMacro(vtkVolumeFractionMeshAlgorithm, vtkVolumeFractionFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Arrays with the volume fraction of one material each, in the order of the materials. An array
   * is cell data or, if there are no cell data of that name, point data of images. An association,
   * vtkDataObject::FIELD_ASSOCIATION_CELLS or _POINTS, selects one of them. All selected arrays, of
   * materials, state and refinement, must have one association.
   *
   * A name is added only once. If neither these arrays nor a MaterialIdArray are selected, and
   * the input has a single array that can hold materials (reals in [0,1], or integers), that
   * array is meshed.
   */
  void AddVolumeFractionArray(const char* name);
  void AddVolumeFractionArray(int association, const char* name);
  /**
   * Adds an array from a list of words; POINTS or CELLS sets the association of the
   * following arrays.
   */
  void AddVolumeFractionWord(const char* word);
  void ClearVolumeFractionArrays();
  int GetNumberOfVolumeFractionArrays();
  const char* GetVolumeFractionArray(int index);
  ///@}

  ///@{
  /**
   * Array with the material of each cell, integers in any numeric type, instead of volume
   * fractions. An association selects cell or point data, as above. Empty, or "None": use volume
   * fractions. Default: empty. ParaView's panels call the form with five arguments (as
   * SetInputArrayToProcess): the first three are ignored, and the association is a number or empty.
   * State files of older versions have only the name.
   */
  const char* GetMaterialIdArray() const { return this->MaterialIdArray.Name.c_str(); }
  void SetMaterialIdArray(const char* name);
  void SetMaterialIdArray(int association, const char* name);
  void SetMaterialIdArray(
    const char*, const char*, const char*, const char* association, const char* name);
  ///@}

  ///@{
  /**
   * Arrays of any numeric type and number of components (velocity, density, temperature) that are
   * transferred to the mesh as cell arrays of the same name. All blocks must have them, with one
   * type and number of components. Blanked cells have the values of their arrays. A name is added
   * only once. Default: none.
   *
   * With STATE_COPY, arrays keep their type, and each element has the values of one cell. This is
   * the cell that contains its centroid (the mean of its corners), if the material of the element
   * fills at least half of it. Otherwise it is, of that cell and its 26 neighbours, the cell with
   * the greatest fraction of the material; then the nearest centre; then the lowest index. For an
   * element that smoothing moved by more than five cells, the fifth cell is used.
   */
  void AddStateArray(const char* name);
  void ClearStateArrays();
  int GetNumberOfStateArrays();
  const char* GetStateArray(int index);
  ///@}

  ///@{
  /**
   * Density, mass per volume of the material (per volume of the cell if the kind is "cell"). Select
   * one array for all materials, or one per material with names as in AddStateKind. The mass of a
   * material in a cell is fraction x cell volume x density. Densities have one component and must
   * not be negative. They are transferred like state arrays, and need not be listed there. Without
   * densities, mass means volume. Default: none.
   */
  void AddDensityArray(const char* name);
  void ClearDensityArrays();
  ///@}

  ///@{
  /**
   * Kinds of arrays, which determine the quantities that STATE_CONSERVE preserves. Entries are
   * name=kind; name is an array, or the common part of arrays per material. Kinds:
   * - mass: values per mass, such as velocity, specific energy or temperature; preserves value x
   *   mass. Default for arrays of reals.
   * - mass*other: weighted by another state array, such as temperature=mass*heat_capacity;
   *   preserves value x mass x other.
   * - volume: values per volume of the material, such as density or pressure; preserves value x
   *   volume of the material. Default for DensityArrays.
   * - cell: values per volume of the whole cell, such as a bulk density; preserves value x cell
   *   volume.
   * - extensive: sums, such as the mass in a cell; elements get sums.
   * - copy: copied as with STATE_COPY. Default for arrays of integers.
   *
   * Values of the kinds cell and extensive are divided among the materials of a cell by volume.
   * Void gets a share only if the cell contains nothing else.
   *
   * Arrays per material are state or density arrays whose names differ only in the number or name
   * of the material, like the names of the fractions, or in " - " and the number. For example, the
   * fractions "Material volume fraction - 1" and the densities "Material density - 1" belong to one
   * material. These arrays become one array, named by their common part ("Material density"). Each
   * element has the value of its material. All materials must have an array. Void has 0.
   */
  void AddStateKind(const char* word);
  void ClearStateKinds();
  ///@}

  ///@{
  /**
   * State arrays whose vectors (3 components), symmetric tensors (6: xx, yy, zz, xy, yz, xz) or
   * tensors (9, row-major) are given along the axes of an image with a direction matrix. They are
   * rotated with the mesh, except with ImageAxes. Of arrays per material, or per component of the
   * velocity, any one stands for all. Copied arrays must be of reals. Default: none.
   */
  void AddRotatedArray(const char* name);
  void ClearRotatedArrays();
  ///@}

  ///@{
  /**
   * File with names of labels (MaterialIdArray), read by rank 0. Formats: a text with a label and
   * its name in each line, label files of ITK-SNAP, lookup tables of FreeSurfer and MRIcron, and
   * the XML of an FSL atlas. Labels without an entry are called "Material 7". Errors state the
   * line: a label is not an integer, or a label or name is repeated. Default: none.
   */
  void SetLabelNamesFile(const char* path);
  ///@}

  ///@{
  /**
   * Boxes whose cells REFINEMENT_AUTOMATIC refines, as with RefinementArray. A box extends from
   * the corner (x0, y0, z0) to (x1, y1, z1), in world coordinates. It selects all cells that it
   * overlaps by more than 1e-3 of their width along every axis; a flat box selects the cells
   * that it cuts. A cell gets the maximum number of halvings of all boxes and the array.
   * Default: no box.
   */
  void AddRefinementBox(
    double x0, double y0, double z0, double x1, double y1, double z1, double halvings = 1.0);
  void ClearRefinementBoxes();
  ///@}

  // Numbers of the options.
  enum StateTransferType
  {
    STATE_AUTOMATIC = 0,
    STATE_COPY = 1,
    STATE_CONSERVE = 2
  };

  enum LostKineticEnergyType
  {
    LOST_ENERGY_REPORT = 0,
    LOST_ENERGY_TO_INTERNAL = 1
  };

  enum UnmeshedMaterialType
  {
    UNMESHED_GIVE = 0,
    UNMESHED_DROP = 1,
    UNMESHED_PARTICLES = 2
  };

  enum RefinementType
  {
    REFINEMENT_OFF = 0,
    REFINEMENT_INPUT_LEVELS = 1,
    REFINEMENT_AUTOMATIC = 2,
    REFINEMENT_COARSEN = 3,
    REFINEMENT_UNIFORM = 4
  };

  enum ChildFractionsType
  {
    CHILD_FRACTIONS_PLANES = 0,
    CHILD_FRACTIONS_PARENT = 1
  };

  enum SmoothingType
  {
    SMOOTHING_OFF = 0,
    SMOOTHING_QUADRIC_SURFACE = 1,
    SMOOTHING_GEOMETRY_BASED = 2
  };

  enum SharpEdgesType
  {
    SHARP_EDGES_OFF = 0,
    SHARP_EDGES_ON = 1,
    SHARP_EDGES_AUTOMATIC = 2
  };

  // options: generated
  /// What cells with material id 0 are. Void: empty space, as in segmentations with a background.
  /// Material: a material, as in codes that number grains from 0. Its id in the mesh is the largest
  /// id plus 1, and its name that of id 0 in the file of names, otherwise Material 0; all other ids
  /// stay. Allowed: Void, Material (or 0 to 1); default Void.
  vfmNumberOption(ZeroLabel, int);
  /// Make materials of ranges of the values of one array, such as grey values. LOW:HIGH is the
  /// values above LOW, up to and including HIGH; LOW has no upper limit, :HIGH no lower limit.
  /// Several ranges, with commas between them, are materials 1, 2, ..; they must not overlap.
  /// Values in no range are void. Allowed: ranges that do not overlap, LOW:HIGH with LOW below
  /// HIGH, LOW or :HIGH, with commas between them, or None; default None.
  vfmTextOption(Threshold);
  /// The volume fraction arrays are level sets: signed distances, or other functions that are
  /// negative inside their material, at the centres of the cells. The part of each cell that is
  /// inside becomes its fraction. Priority: a point belongs to the first array that is negative
  /// there, so each level set may contain those before it, as layers of films do. Lowest: to the
  /// array of the lowest value, if it is negative. Fill: as Lowest, also if it is positive, so that
  /// there is no void. Off: the arrays are volume fractions. Allowed: Off, Priority, Lowest, Fill
  /// (or 0 to 3); default Off.
  vfmNumberOption(LevelSets, int);
  /// Sign of level sets inside their material. With Positive, Lowest and Fill take the highest
  /// value. Allowed: Negative, Positive (or 0 to 1); default Negative.
  vfmNumberOption(LevelSetInside, int);
  /// Leave the mesh of an image with a direction matrix in the axes of the image. The sides of the
  /// domain then lie along x, y and z. Off: the mesh is rotated to the position of the image in
  /// space. Refinement boxes are in space; so are state arrays, except Rotated Arrays. Allowed: on
  /// or off; default off.
  vfmSwitchOption(ImageAxes);
  /// Mesh the void as well, as material 0, conforming with the materials. Allowed: on or off;
  /// default off.
  vfmSwitchOption(MeshVoid);
  /// Make a mesh of a plane from input that is one layer of cells along an axis: quadrilaterals, or
  /// triangles instead of tetrahedra, of all materials. Interfaces are curves. Volumes in reports
  /// are areas. Off: such input gives a layer of solid elements. Allowed: on or off; default off.
  vfmSwitchOption(Flat);
  /// Axes along which the input is one period of a material that repeats. The mesh of one side is
  /// then a copy of the mesh of the opposite side, at exactly one period from it, and the point
  /// array PeriodicPartner pairs their nodes. Surfaces, volumes and fragments continue across these
  /// sides. Along each of the axes, the input needs at least 3 cells, and for a refined mesh an
  /// even number of cells of the coarsest level. Allowed: Off, X, Y, XY, Z, XZ, YZ, XYZ (or 0 to
  /// 7); default Off.
  vfmNumberOption(Periodic, int);
  /// Sides across periodic axes. Flat: their nodes stay in the planes. Free: nodes move as inside
  /// the domain, which gives the best surfaces; the sides wave by up to a cell where they meet
  /// surfaces. Joined: there are no sides; elements at opposite sides share nodes, so some elements
  /// seem to extend across the whole domain. Surfaces are those of Free. Tetrahedra are Flat or
  /// Joined. Allowed: Flat, Free, Joined (or 0 to 2); default Flat.
  vfmNumberOption(PeriodicSides, int);
  /// Keep films, threads and drops that are thinner than a cell, and so fill no cell by more than
  /// half: they get the cells in which they have most of their material. Elements of films and
  /// threads that miss their volume may have less quality than others. Oblique threads of less than
  /// a cell can still become thicker than they are; the table of materials tells by how much. Off:
  /// thin parts are torn or lost. Only for volume fractions with an IsoValue of 0.5; material ids
  /// stay as they are. Allowed: on or off; default on.
  vfmSwitchOption(ThinParts);
  /// Thickness, in cells, below which Thin Parts gives no cells to a film, thread or drop. Its
  /// material belongs to elements within one cell of it, or else to none (Unmeshed Material). Below
  /// 0.2, elements that are oblique to the cells cannot be thin enough, and make the part larger
  /// than it is. Allowed: a number from 0 to 1; default 0.25.
  vfmNumberOption(LeastThickness, double);
  /// Remove small fragments and cavities. A face-connected region of one material, or of void, with
  /// fewer cells than this becomes part of the material or void with which it shares the most
  /// faces. 0: all regions stay. Allowed: an integer, 0 or more; default 0.
  vfmNumberOption(MinimumRegionCells, int);
  /// Clip volume fractions that lie outside [0, 1] by at most this value, such as over- and
  /// undershoots of a simulation. Sums above 1 by at most this value, or by at most 0.001, are
  /// scaled back to 1. Larger deviations are errors. The default of 1e-6 covers rounding only.
  /// Allowed: a number from 1e-6 to 0.1; default 1e-6.
  vfmNumberOption(FractionTolerance, double);
  /// A cell is void if its materials together fill less than this fraction of it. Volumes are
  /// conserved only at 0.5. Allowed: a number above 0 and below 1; default 0.5.
  vfmNumberOption(IsoValue, double);
  /// How elements get the values of state arrays. Copy: each element takes the values of the cell
  /// that contains its centroid. If its material fills less than half of that cell, the neighbour
  /// cell with most of the material is used. Nothing is averaged, so sums are not conserved.
  /// Conserve: the contents of the cells are distributed to the elements, so that mass, momentum
  /// and energy of each material match the input. Automatic: Conserve if Density Arrays names an
  /// array, otherwise Copy. Allowed: Automatic, Copy, Conserve (or 0 to 2); default Automatic.
  vfmNumberOption(StateTransfer, int);
  /// How Conserve reconstructs the state within a cell. 1: constant. 2: linear, within the range of
  /// the neighbour cells. Allowed: an integer from 1 to 2; default 2.
  vfmNumberOption(StateOrder, int);
  /// Velocity. Conserve preserves and reports the momentum of each material, and reports its
  /// kinetic energy and the part that is lost. Select an array of three components, or one of three
  /// arrays with a component each (X velocity). Transferred like State Arrays. Allowed: the name of
  /// a cell array, or None; default None.
  vfmTextOption(VelocityArray);
  /// Internal energy per unit mass. Conserve preserves and reports it for each material. If every
  /// material has its own energy array, select any one of them. Transferred like State Arrays.
  /// Allowed: the name of a cell array, or None; default None.
  vfmTextOption(EnergyArray);
  /// Add the velocity of the nodes as a point array, the initial state of a Lagrangian code. The
  /// momentum of all nodes equals the momentum of all elements. Allowed: on or off; default off.
  vfmSwitchOption(NodalVelocity);
  /// Treatment of the kinetic energy that is lost where one element, or one node, moves with the
  /// mean velocity of several cells. Report: the table of materials lists it. Internal Energy: it
  /// is added to Energy Array, so that the sum of both energies matches the input. With State Order
  /// 2 it may be negative: elements can have slightly more kinetic energy than their cells.
  /// Allowed: Report, InternalEnergy (or 0 to 1); default Report.
  vfmNumberOption(LostKineticEnergy, int);
  /// Treatment of material that is not attached to any element of its kind, such as small drops and
  /// removed regions. Give: Conserve adds it to the nearest fragment of its material within a few
  /// cells. Drop: it is left out. Particles: it becomes one particle per cell, which elements do
  /// not count. The table of materials lists how much is left out. Allowed: Give, Drop, Particles
  /// (or 0 to 2); default Give.
  vfmNumberOption(UnmeshedMaterial, int);
  /// Join particles of neighbour cells, up to 27 into one, with their momentum. Lost Kinetic Energy
  /// tells what happens to the kinetic energy that they lose. Allowed: on or off; default off.
  vfmSwitchOption(ParticleClusters);
  /// Particles below this part of a cell join one in a neighbour cell. Allowed: a number from 0 to
  /// 1; default 0.001.
  vfmNumberOption(LeastParticle, double);
  /// Turn each cell of a material into one hexahedron and move no nodes: a quick preview. Allowed:
  /// on or off; default off.
  vfmSwitchOption(StairStep);
  /// How the nodes are placed. Quadric Surface: surface nodes follow smooth local quadrics of the
  /// surface, which gives the best mesh. Geometry Based: surface nodes stay on the facets of the
  /// initial surface. Off: the surface keeps the steps of the grid, with a thin layer of hexahedra
  /// along them; valid, but neither smooth nor of good quality. Allowed: Off, QuadricSurface,
  /// GeometryBased (or 0 to 2); default QuadricSurface.
  vfmNumberOption(Smoothing, int);
  /// Detect edges and corners in the volume fractions and preserve them, as in machined parts,
  /// shapes and closed surfaces. Off: they are rounded by about a third of a cell. On: all points
  /// of interfaces are tested. Automatic: only between materials where samples of the points that
  /// one surface does not fit show edges, so not in fluids and noise. Requires Smoothing Quadric
  /// Surface and an IsoValue of 0.5. Allowed: Off, On, Automatic (or 0 to 2); default Automatic.
  vfmNumberOption(SharpEdges, int);
  /// Place the nodes of interfaces on the closed surfaces from which the volume fractions were
  /// computed, and take edges, corners and sides from their triangles. Off: from the fractions
  /// alone. No effect on input without surfaces: they come from surface files and Volume Fraction
  /// Of Surface. Requires Smoothing Quadric Surface and an IsoValue of 0.5. Allowed: Off, On (or 0
  /// to 1); default On.
  vfmNumberOption(SurfaceTargets, int);
  /// Least angle between triangles of a surface, in degrees, at which their common edge is a sharp
  /// edge of the mesh and separates two sides. Smaller angles find blunter edges, and also those of
  /// coarse triangles on round surfaces. No effect without Surface Targets, or on input without
  /// surfaces. Allowed: a number from 1 to 179; default 40.
  vfmNumberOption(EdgeAngle, double);
  /// Smooth the steps of material ids, by this number of averaging passes over neighbour cells.
  /// Each material keeps the volume of its cells, and thin parts stay. 2 or 3 passes suit most
  /// images; more round edges. Fractions are not smoothed. Allowed: an integer from 0 to 10;
  /// default 0.
  vfmNumberOption(LabelSmoothing, int);
  /// Nodes of the elements. Linear: corners only. Quadratic: also mid nodes of edges, hexahedra of
  /// 20 nodes and tetrahedra of 10. Quadratic27: hexahedra also have mid nodes of faces and a
  /// centre, 27 nodes. Mid nodes of interface edges lie on the curved interface, so elements follow
  /// it more closely; Smoothing must be Quadric Surface. All elements are positive throughout.
  /// Allowed: Linear, Quadratic, Quadratic27 (or 0 to 2); default Linear.
  vfmNumberOption(ElementOrder, int);
  /// Shift the surfaces until each fragment has the volume given by its volume fractions. Allowed:
  /// on or off; default on.
  vfmSwitchOption(ConserveVolume);
  /// Width of the cells that are meshed, in length units: one number, or three along the axes of
  /// the input. The cells of the input are first replaced by as many equal cells as come nearest to
  /// it, and each material keeps its volume. Twice the width gives an eighth of the elements, and
  /// smooths the steps of material ids. Refinement then refines the new cells; Label Smoothing
  /// smooths material ids before. Parts thinner than half of the width get lost. 0: the cells of
  /// the input. Allowed: a number, 0 (as read) or more, or three such numbers with commas between
  /// them; default 0.
  vfmTextOption(CellWidth);
  /// Widths of cells of single materials, name=width or id=width with commas between them, in
  /// length units; small=N:width is for all materials of fewer than N cells in the input. All
  /// others have Cell Width. A cell is halved while it is wider than the width of a material in it
  /// or next to it, and interfaces run through cells of several widths. auto: cells are as wide as
  /// Allowed Error lets them be, at most Cell Width, or 4 cells of the input. Tetrahedra are those
  /// of Cells, also with Lattice; TetGen has the smallest width at all interfaces. Allowed: auto,
  /// or entries such as steel=0.5, 3=1 or small=100:0.5 with commas between them and widths above
  /// 0, or None; default None.
  vfmTextOption(MaterialWidths);
  /// Distance that surfaces may be from those of the input, in cells of the input, if Material
  /// Widths is auto. Allowed: a number, 0 or more; default 0.5.
  vfmNumberOption(AllowedError, double);
  /// Where the mesh is refined; each level halves the cells. Input Levels: where the input has
  /// finer levels (AMR). Off: nowhere, all cells are of the coarsest level. Automatic: where the
  /// shape of the materials requires it. Coarsen: the cells of the input stay near interfaces and
  /// get larger away from them. Uniform: everywhere, so that thin parts get more elements across.
  /// Allowed: Off, InputLevels, Automatic, Coarsen, Uniform (or 0 to 4); default InputLevels.
  vfmNumberOption(Refinement, int);
  /// Maximum number of levels above the coarsest. Automatic (-1) uses all levels of the input. A
  /// refined image gets 1 level, or as many as user-selected cells request. Coarsen makes as many
  /// as the numbers of cells allow, up to 3. Uniform multiplies the number of elements by eight per
  /// level. Finer data of the input are averaged. Allowed: an integer from -1 (automatic) to 10;
  /// default -1.
  vfmNumberOption(MaximumLevel, int);
  /// All interfaces get the finest cells. Off: each place gets the level of the input or of the
  /// criteria there, and interfaces cross levels. With Coarsen all cells are then as coarse as
  /// possible. Tetrahedra are those of Cells then, also with Lattice; TetGen always has the finest
  /// cells at interfaces. Allowed: on or off; default on.
  vfmSwitchOption(FineInterfaces);
  /// Minimum number of finest cells between an interface and larger cells. If Fine Interfaces is
  /// off: fine cells around the places that Automatic refines. Allowed: an integer from 2 to 64;
  /// default 2.
  vfmNumberOption(FineLayers, int);
  /// Refinement Automatic halves cells at films, gaps, rods and small bodies thinner than this
  /// number of cells. 0: off. Allowed: a number from 0 (off) to 3; default 2.
  vfmNumberOption(ThinCells, double);
  /// Refinement Automatic halves cells where an interface turns by more than this angle per cell,
  /// in radians. 0: off. Allowed: a number, 0 (off) or more; default 0.
  vfmNumberOption(CurvaturePerCell, double);
  /// Refinement Automatic halves, once, the cells whose material had to be changed to make the
  /// interfaces manifold. Allowed: on or off; default off.
  vfmSwitchOption(RefineFlippedCells);
  /// Refinement Automatic refines all cells within this number of layers of an interface, to
  /// Maximum Level. 0: off. Allowed: an integer from 0 to 64; default 0.
  vfmNumberOption(InterfaceLayers, int);
  /// Array of the number of times that Refinement Automatic halves each cell, 0 to 10 (0 and 1 in a
  /// mask), up to Maximum Level. With Thin Cells 0 only these cells are refined. Without Fine
  /// Interfaces each place gets the level that is requested there. Allowed: the name of a cell
  /// array, or None; default None.
  vfmTextOption(RefinementArray);
  /// Divide cells of high aspect ratio first (slices thicker than their pixels), until no width of
  /// a cell exceeds another by more than this factor. 1.5 gives elements of good shape. 0: off.
  /// Allowed: 0 (off) or a number, 1.1 or more; default 0.
  vfmNumberOption(MaximumAspectRatio, double);
  /// Volume fractions in the halves, or parts, of a mixed cell where there are no finer data.
  /// Planes: the cell is cut by planes that preserve the volume of each material. Parent: the parts
  /// get the fractions of the cell. Material ids keep their steps with either choice, unless Label
  /// Smoothing is on. Allowed: Planes, Parent (or 0 to 1); default Planes.
  vfmNumberOption(ChildFractions, int);
  /// Pairs of materials whose interfaces are split: the elements on each side get their own nodes,
  /// also where several fragments meet at a line or a corner. A pair is two names or ids with a
  /// slash between them, such as steel/copper or 1/3; * is any material. The point array
  /// OriginalPointIds has the ids of the nodes before. Allowed: pairs of materials such as
  /// steel/copper or 1/3 with commas between them, all, or None; default None.
  vfmTextOption(SplitInterfaces);
  /// Connection of both sides of split interfaces in files. Cohesive: elements of zero thickness in
  /// blocks of their own, in .inp, Exodus and .msh files. Contact, Tied: contact pairs or ties in
  /// .inp files. None: the sides are free. Allowed: None, Cohesive, Contact, Tied (or 0 to 3);
  /// default None.
  vfmNumberOption(SplitConnection, int);
  /// Cut the hexahedra along interfaces into this number of layers, as for boundary layers or
  /// contact. The cell array Layer counts them from the surface. A fragment gets layers along its
  /// whole surface. 0, 1: no layers. Allowed: an integer from 0 to 20; default 0.
  vfmNumberOption(Layers, int);
  /// Thickness of each layer relative to the one before, from the surface. Allowed: a number from 1
  /// to 10; default 1.5.
  vfmNumberOption(LayerGrowth, double);
  /// Thickness of the first layer, where there is room: where the hexahedra are high enough for all
  /// layers. Layers grow less where there is less room, and the last one is thicker where there is
  /// more. 0: layers fill the hexahedra along the interface, which are half a cell high. Allowed: a
  /// number, 0 or more; default 0.
  vfmNumberOption(FirstLayer, double);
  /// Unit of First Layer. Cells: the mean width of the finest cells. Length: the length unit of the
  /// input. Allowed: Cells, Length (or 0 to 1); default Cells.
  vfmNumberOption(FirstLayerUnit, int);
  /// Pairs of materials whose interfaces have layers. A pair is two names or ids with a slash
  /// between them, such as water/steel or 1/3; * is any material, 0 or Void the void. None: all.
  /// Allowed: pairs of materials such as steel/copper or 1/3 with commas between them, all, or
  /// None; default None.
  vfmTextOption(LayerInterfaces);
  /// Side of the interfaces with layers: the elements of both materials of each pair, or only those
  /// of the first. Allowed: BothMaterials, FirstMaterial (or 0 to 1); default BothMaterials.
  vfmNumberOption(LayersOn, int);
  /// Axes across which the sides of the domain have layers as well, such as walls. Allowed: Off, X,
  /// Y, XY, Z, XZ, YZ, XYZ (or 0 to 7); default Off.
  vfmNumberOption(LayerSides, int);
  /// Target of smoothing for the scaled Jacobian. Larger values give better hexahedra that follow
  /// the surfaces less closely. 0 is automatic: 0.55 with one material, 0.5 with several. Allowed:
  /// a number from 0 (automatic) to below 1; default 0.
  vfmNumberOption(TargetScaledJacobian, double);
  /// Add the cell array ScaledJacobian, and its minimum and mean to the field data. It is 1 for a
  /// cube and above 0 for a valid hexahedron. Allowed: on or off; default on.
  vfmSwitchOption(ComputeQuality);
  /// Number of threads. 0 is automatic: all cores on one rank, one thread per rank on several. The
  /// mesh does not depend on it. Allowed: an integer, 0 (automatic) or more; default 0.
  vfmNumberOption(NumberOfThreads, int);
  /// Field data with a row for each fragment, surface, curve and vertex of the whole mesh, such as
  /// target volumes, areas and materials on both sides, on every rank. Automatic: tables of at most
  /// 100,000 rows. Off: none, so that the memory of a rank depends on its part of the mesh only.
  /// Ids, the table of fragments and the files of each rank do not need them; names of surfaces in
  /// files do. Allowed: Automatic, Off, On (or 0 to 2); default Automatic.
  vfmNumberOption(WholeTables, int);
  // end of options

  /**
   * Returns the widths of the cells of an image, along its own axes; zeros for other input. The
   * panel shows how many cells CellWidth makes of them.
   */
  double* GetInputSpacing() VTK_SIZEHINT(3);

protected:
  explicit vtkVolumeFractionMeshAlgorithm(vfm::ElementKind elements);
  ~vtkVolumeFractionMeshAlgorithm() override = 0; // an abstract class

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  std::vector<vfm::ChosenArray> VolumeFractionArrays;
  int WordAssociation = vfm::AnyAssociation; // association of the following words
  vfm::ChosenArray MaterialIdArray;
  std::vector<std::string> StateArrays;
  double InputSpacing[3] = { 0.0, 0.0, 0.0 };

private:
  vtkVolumeFractionMeshAlgorithm(const vtkVolumeFractionMeshAlgorithm&) = delete;
  void operator=(const vtkVolumeFractionMeshAlgorithm&) = delete;

  vfm::MaterialArrays FindMaterials(vtkDataObject* input, vfm::Ranks& ranks) const; // collective
  void PrintArrays(ostream& os, vtkIndent indent) const;
  vfm::StateChoice ChooseState(vtkDataObject* input, vfm::Ranks& ranks) const; // collective
  void Warn(const std::string& text, const vfm::Ranks& ranks) const;
  void Run(vtkDataObject* input, vfm::MessageRanks& ranks, const vfm::MeshOutputs& outputs);
};

#endif
