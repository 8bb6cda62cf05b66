/**
 * @class   vtkVolumeFractionMeshAlgorithm
 * @brief   base of the filters from cell-centred volume fractions to finite-element meshes
 *
 * Input: vtkImageData, vtkUniformGrid, vtkRectilinearGrid, vtkUnstructuredGrid or vtkStructuredGrid whose cells are those
 * of a Cartesian grid (hexahedra or voxels with sides along the axes, in any order, as Exodus files hold them), or a composite
 * data set of them whose blocks tile one grid, or several levels of a refined one: vtkOverlappingAMR, vtkNonOverlappingAMR and
 * any other whose blocks' cells are 2, 4, 8 .. times as wide as those of the finest. Where finer blocks are coarser data are ignored. Cells of less than three dimensions are left out. The materials come from cell arrays, or from
 * point arrays of images, whose points then are the centres of cells (one level only), either
 * - one volume fraction array a material (AddVolumeFractionArray), of any numeric type, values in
 *   [0,1], or 0..255 when unsigned char; material i is the i-th array added, counted from 1; what the
 *   arrays of a cell leave of 1 is void; or
 * - one array of whole numbers (MaterialIdArray) that names the material of each cell, 0 for void.
 * Images with a direction matrix, which must be orthonormal, are meshed in their own axes, and the mesh is turned; sides of the domain
 * and its bounds are those of their axes, state arrays are left as they are.
 *
 * Ghost cells (vtkGhostType) are dropped. Blanked cells are void.
 *
 * Under MPI the input may be dealt to the processes of the Controller in any way, and some may have none: the cells
 * are shared out anew, one box a process, unless they already are so. All processes must update together. The mesh,
 * its ids and its field data do not depend on the number of processes. Each process gets its own cells; points
 * between processes are repeated with equal GlobalPointIds. A run on several processes cannot be aborted.
 * A host code that knows the processes across the faces of its boxes says so (FaceNeighbours); each then meshes its own
 * cells.
 *
 * Output port 0: the mesh, vtkUnstructuredGrid. The geometry that it resolves, vtkPolyData: output port 1 its surfaces, port 2 the
 * curves where surfaces meet, port 3 the vertices where curves meet or end. Each facet, edge and vertex is on one process.
 * Their ids, and the tables of what bounds what, are the same on every process.
 * Output port 4: the materials, vtkTable, a row each, on the first process alone.
 *
 * Input that cannot be meshed, on any process, gives one error message and empty outputs on all, whose field data say why (MeshError). So does
 * input that failed. The update itself does not fail (Parallel/FailedOutput tells why).
 */
#ifndef vtkVolumeFractionMeshAlgorithm_h
#define vtkVolumeFractionMeshAlgorithm_h

#include "ChosenArray.h" // for member
#include "vtkUnstructuredGridAlgorithm.h"
#include "vtkVolumeFractionMeshFiltersModule.h" // for export macro

#include <array>  // for member
#include <string> // for member
#include <vector> // for member

class vtkMultiProcessController;

namespace vfm
{
class MessageRanks;
class Ranks;
struct InputLevels;
struct MaterialArrays;
struct MeshOutputs;
struct MesherOptions;
struct StateChoice;
} // namespace vfm

class VTKVOLUMEFRACTIONMESHFILTERS_EXPORT vtkVolumeFractionMeshAlgorithm :
  public vtkUnstructuredGridAlgorithm
{
public:
  vtkTypeMacro(vtkVolumeFractionMeshAlgorithm, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The arrays that hold the volume fraction of one material each, in the order of the materials: of the cells, or where cells
   * have none of that name of the points of images. association: vtkDataObject::FIELD_ASSOCIATION_CELLS or _POINTS, whose alone are
   * meant. All arrays that are chosen, of materials, state and refinement, must have one association.
   * An array that is on the list already is not added again. Where nothing is chosen, no MaterialIdArray either, and the input has a
   * single array that can hold materials (fractions in [0,1] of a real type, or whole numbers), that one is meshed.
   */
  void AddVolumeFractionArray(const char* name);
  void AddVolumeFractionArray(int association, const char* name);
  /**
   * The same from lists of words: POINTS or CELLS tells what the arrays that follow belong to.
   */
  void AddVolumeFractionWord(const char* word);
  void ClearVolumeFractionArrays();
  int GetNumberOfVolumeFractionArrays();
  const char* GetVolumeFractionArray(int index);
  ///@}

  ///@{
  /**
   * The array that names the material of each cell by a whole number, of any type, instead of volume fractions; with an association as
   * for those. Empty, or "None": use volume fractions. Default: empty. The form of five is that in which ParaView's panels choose arrays
   * (SetInputArrayToProcess); the first three say nothing, and the association is a number or empty. Files of states of older versions
   * have the name alone.
   */
  void SetMaterialIdArray(const char* name);
  void SetMaterialIdArray(int association, const char* name);
  void SetMaterialIdArray(
    const char*, const char*, const char*, const char* association, const char* name);
  const char* GetMaterialIdArray() const { return this->MaterialIdArray.Name.c_str(); }
  ///@}

  ///@{
  /**
   * Arrays of any numeric type and number of components (velocity, density, temperature) that the mesh carries
   * along as cell arrays of the same name. Copied (StateTransfer), they keep their type, piecewise constant: each element has the values of one
   * cell, unchanged. That is the cell that holds its centroid (the mean of its corners), if the element's
   * material fills at least half of it; else, of that cell and its 26 neighbours, the one with the greatest fraction
   * of the element's material, of equal ones that with the nearest centre, then that with the lowest index. An
   * element that smoothing moved over more than five cells looks in the fifth.
   * All blocks need them, of one type and number of components. Blanked cells have the values of their arrays.
   * A name that is on the list already is not added again. Default: none.
   */
  void AddStateArray(const char* name);
  void ClearStateArrays();
  int GetNumberOfStateArrays();
  const char* GetStateArray(int index);
  ///@}

  enum StateTransferType
  {
    STATE_AUTOMATIC = 0,
    STATE_COPY = 1,
    STATE_CONSERVE = 2
  };

  ///@{
  /**
   * How elements come to the values of state arrays.
   * STATE_COPY: each has those of one cell, as told above; sums over the mesh are not those of the input.
   * STATE_CONSERVE: what the cells hold of each material is given to its elements, all of it and no more: the arrays become averages
   * of type double over the parts of the cells that an element covers, within the bounds of the cells around, and volume, mass,
   * momentum, energy and whatever else is chosen have the sums of the input, to rounding.
   * STATE_AUTOMATIC: STATE_CONSERVE where DensityArrays names an array, else STATE_COPY. Default: STATE_AUTOMATIC.
   */
  vtkSetClampMacro(StateTransfer, int, STATE_AUTOMATIC, STATE_CONSERVE);
  vtkGetMacro(StateTransfer, int);
  ///@}

  ///@{
  /**
   * The density, mass per volume of the material (not of the cell, but for those of the kind "cell"): one array for all materials, or
   * one a material with names as told at AddStateKind. Mass of a material in a cell is fraction x volume of the cell x density. They are
   * carried as state arrays are, and need not be among them. Of one component; none may be negative. Without any, mass is the volume of the fractions.
   * Default: none.
   */
  void AddDensityArray(const char* name);
  void ClearDensityArrays();
  int GetNumberOfDensityArrays();
  const char* GetDensityArray(int index);
  ///@}

  ///@{
  /**
   * What the values of an array are, and so what STATE_CONSERVE keeps of it: words name=kind, where name is that of an array, or the stem of
   * arrays a material. Kinds:
   * - mass: per mass, as velocity, specific energy, temperature: value x mass is kept. The default of arrays of real numbers.
   * - mass*other: the same weighed with another state array, as temperature=mass*heat_capacity: value x mass x other is kept.
   * - volume: per volume of the material, as density, pressure: value x volume of the material. The default of DensityArrays.
   * - cell: per volume of the whole cell, as a bulk density: value x volume of the cell.
   * - extensive: sums, as the mass in a cell; elements get sums.
   * - copy: copied as by STATE_COPY. The default of arrays of whole numbers.
   * Cell and extensive are shared by the materials of a cell in proportion to their volumes; void has a part only where nothing else is.
   *
   * Arrays a material: state or density arrays whose names differ only in the number or name of the material, as those of its
   * fractions do ("Material volume fraction - 1" and "Material density - 1"), or in " - " and the number, become one array with the name
   * of what they share ("Material density"): an element has it from the array of its material. There must be one for every material.
   * Void has 0 of them.
   */
  void AddStateKind(const char* word);
  void ClearStateKinds();
  int GetNumberOfStateKinds();
  const char* GetStateKind(int index);
  ///@}

  ///@{
  /**
   * 1: what is conserved is constant in each cell; 2: linear, limited by the values around. Default: 2.
   */
  vtkSetClampMacro(StateOrder, int, 1, 2);
  vtkGetMacro(StateOrder, int);
  ///@}

  ///@{
  /**
   * By STATE_CONSERVE: the velocity, of three components and the kind mass, and the internal energy per mass, of one. Carried as state arrays
   * are. Of these momentum and energies of the materials are told (field data, output port 4). Three arrays of one component are one velocity
   * when any is named, in whose name the axis stands alone ("X velocity", "velocity_x"), or what they share: the mesh has "velocity". Of
   * energies a material any one is named, or the stem. Empty, or "None": none. Default: empty.
   */
  vtkSetStdStringFromCharMacro(VelocityArray);
  vtkGetCharFromStdStringMacro(VelocityArray);
  vtkSetStdStringFromCharMacro(EnergyArray);
  vtkGetCharFromStdStringMacro(EnergyArray);
  ///@}

  ///@{
  /**
   * By STATE_CONSERVE with a VelocityArray: add the velocity of the nodes, a point array of its name. A node has the momentum of an equal
   * part of each of its elements over their mass, so the momentum of all nodes is that of all elements. Default: off.
   */
  vtkSetMacro(NodalVelocity, bool);
  vtkGetMacro(NodalVelocity, bool);
  vtkBooleanMacro(NodalVelocity, bool);
  ///@}

  enum LostKineticEnergyType
  {
    LOST_ENERGY_REPORT = 0,
    LOST_ENERGY_TO_INTERNAL = 1
  };

  ///@{
  /**
   * What becomes of the kinetic energy that the mesh lacks since an element, or with NodalVelocity a node, has one mean velocity.
   * LOST_ENERGY_REPORT: it is told in the field data. LOST_ENERGY_TO_INTERNAL: it is added to EnergyArray where it is lost, so that the sum of
   * both energies is that of the input. Default: LOST_ENERGY_REPORT.
   */
  vtkSetClampMacro(LostKineticEnergy, int, LOST_ENERGY_REPORT, LOST_ENERGY_TO_INTERNAL);
  vtkGetMacro(LostKineticEnergy, int);
  ///@}

  enum UnmeshedMaterialType
  {
    UNMESHED_GIVE = 0,
    UNMESHED_DROP = 1
  };

  ///@{
  /**
   * What becomes by STATE_CONSERVE of material apart from all elements of its kind: spray, removed regions. UNMESHED_GIVE: it is given to the
   * nearest fragment of its material within three cells; what lies farther is dropped. UNMESHED_DROP: all of it is. What is
   * dropped is told in the field data and by a warning. Default: UNMESHED_GIVE.
   */
  vtkSetClampMacro(UnmeshedMaterial, int, UNMESHED_GIVE, UNMESHED_DROP);
  vtkGetMacro(UnmeshedMaterial, int);
  ///@}

  ///@{
  /**
   * A cell is void when its materials fill less than this part of it; in (0,1). Default: 0.5.
   */
  vtkSetMacro(IsoValue, double);
  vtkGetMacro(IsoValue, double);
  ///@}

  ///@{
  /**
   * How far outside [0,1] fractions may lie: up to that they are clipped, and sums above 1 by no more are scaled back; other input is
   * refused. 1e-6 to 0.1. Default: 1e-6, for rounding alone.
   */
  vtkSetClampMacro(FractionTolerance, double, 1e-6, 0.1);
  vtkGetMacro(FractionTolerance, double);
  ///@}

  ///@{
  /**
   * Smooth the steps that labels (MaterialIdArray) make, by this many passes of an average over the cells around, 0 to 10: cells
   * at interfaces become mixed, each filled most by its own label, and every label keeps the volume of its cells. 2 or 3 serve
   * most labels; more rounds off edges. 0: off. Volume fractions are not smoothed. Default: 0.
   */
  vtkSetClampMacro(LabelSmoothing, int, 0, 10);
  vtkGetMacro(LabelSmoothing, int);
  ///@}

  ///@{
  /**
   * A file that names labels (MaterialIdArray), read by the first process: a text with a line for each, the label and its name, a label
   * file of ITK-SNAP, a lookup table of FreeSurfer or MRIcron, or the XML of an atlas of FSL. Labels that it does not name are
   * called "Material 7". Errors tell the line: no whole number, a label or a name twice. Default: none.
   */
  vtkSetStdStringFromCharMacro(LabelNamesFile);
  vtkGetCharFromStdStringMacro(LabelNamesFile);
  ///@}

  ///@{
  /**
   * A region, cells of one material or of void connected over faces, of fewer cells than this is given to the material or
   * void with which it shares the most faces: no spray, no crumbs, no small cavities. 0: all stay. Default: 0.
   */
  vtkSetClampMacro(MinimumRegionCells, int, 0, VTK_INT_MAX);
  vtkGetMacro(MinimumRegionCells, int);
  ///@}

  enum RefinementType
  {
    REFINEMENT_OFF = 0,
    REFINEMENT_INPUT_LEVELS = 1,
    REFINEMENT_AUTOMATIC = 2,
    REFINEMENT_COARSEN = 3,
    REFINEMENT_UNIFORM = 4
  };

  ///@{
  /**
   * Where the mesh is finer than elsewhere. Each level halves the cells of the one before along every axis.
   * REFINEMENT_OFF: nowhere; all cells are those of the coarsest level of the input.
   * REFINEMENT_INPUT_LEVELS: where the input is, which is nowhere unless it has several levels (AMR).
   * REFINEMENT_AUTOMATIC: where criteria want it; the coarsest level of the input is that of the mesh.
   * REFINEMENT_COARSEN: near interfaces; the finest level of the input is that of the mesh, cells away from interfaces get larger.
   * REFINEMENT_UNIFORM: everywhere, so that thin parts get more elements across: each level makes eight times as many.
   * Default: REFINEMENT_INPUT_LEVELS.
   */
  vtkSetClampMacro(Refinement, int, REFINEMENT_OFF, REFINEMENT_UNIFORM);
  vtkGetMacro(Refinement, int);
  ///@}

  ///@{
  /**
   * How many levels finer than the coarsest the mesh has at most, 0 to 10. Finer data are averaged. -1: all that the input has, by
   * REFINEMENT_COARSEN as many as its sizes allow, but no more than 3 beyond those of the input, by REFINEMENT_AUTOMATIC and
   * REFINEMENT_UNIFORM of an input of one level 1, or by REFINEMENT_AUTOMATIC what chosen cells ask for, if that is more. Default: -1.
   */
  vtkSetClampMacro(MaximumLevel, int, -1, 10);
  vtkGetMacro(MaximumLevel, int);
  ///@}

  ///@{
  /**
   * Whether all interfaces get the finest cells. Off: cells are only as fine as the input's levels (REFINEMENT_INPUT_LEVELS) or the
   * criteria (REFINEMENT_AUTOMATIC, with FineLayers of the cells that a place wants around it) ask at each place, and interfaces
   * run through coarser cells and transitions. REFINEMENT_COARSEN asks nowhere: its mesh then has cells of its coarsest level
   * alone. Hexahedra only: interfaces of tetrahedra always get the finest cells. Default: on.
   */
  vtkSetMacro(FineInterfaces, bool);
  vtkGetMacro(FineInterfaces, bool);
  vtkBooleanMacro(FineInterfaces, bool);
  ///@}

  ///@{
  /**
   * How many of the finest cells lie at least between an interface, or with FineInterfaces off a place where a criterion asks for
   * them, and larger cells; 2 or more. Default: 2.
   */
  vtkSetClampMacro(FineLayers, int, 2, 64);
  vtkGetMacro(FineLayers, int);
  ///@}

  enum ChildFractionsType
  {
    CHILD_FRACTIONS_PLANES = 0,
    CHILD_FRACTIONS_PARENT = 1
  };

  ///@{
  /**
   * Cells whose aspect ratio, the largest of their widths over the smallest, is above this are cut across their long axes first, each
   * into as few equal parts as it takes (of a rectilinear grid each layer into its own number), like those of all levels of an input
   * that has several. What the parts hold: ChildFractions; every material keeps its volume in each cell. An element carries the
   * state of the cell of the input. 1.1 or more, 1.5 makes elements of good shape; 0: no cell is cut. Default: 0.
   */
  vtkSetMacro(MaximumAspectRatio, double);
  vtkGetMacro(MaximumAspectRatio, double);
  ///@}

  ///@{
  /**
   * What the halves, or parts, of a mixed cell hold where the input has no finer data: pieces cut by planes that keep the volume of every
   * material, or the fractions of the cell. Labels (MaterialIdArray) tell of no planes: their steps stay, unless LabelSmoothing is
   * on. Default: CHILD_FRACTIONS_PLANES.
   */
  vtkSetClampMacro(ChildFractions, int, CHILD_FRACTIONS_PLANES, CHILD_FRACTIONS_PARENT);
  vtkGetMacro(ChildFractions, int);
  ///@}

  ///@{
  /**
   * What REFINEMENT_AUTOMATIC looks for, on the finest level of the input; 0: not. All interfaces get the level that the
   * neediest place wants, up to MaximumLevel; with FineInterfaces off each place what it wants. Cells can be chosen by name, too
   * (RefinementArray, RefinementBoxes).
   * ThinCells: films, gaps, rods and small bodies thinner than so many cells, at most 3, until they are no longer. Default: 2.
   * CurvaturePerCell: interfaces that turn by more than so many radians over a cell, until they turn by less. Default: 0.
   * RefineFlippedCells: cells whose material had to be changed to make the interfaces manifold; once. Default: off.
   * InterfaceLayers: all cells within so many layers of an interface, to MaximumLevel. Default: 0.
   */
  vtkSetClampMacro(ThinCells, double, 0.0, 3.0);
  vtkGetMacro(ThinCells, double);
  vtkSetClampMacro(CurvaturePerCell, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(CurvaturePerCell, double);
  vtkSetMacro(RefineFlippedCells, bool);
  vtkGetMacro(RefineFlippedCells, bool);
  vtkBooleanMacro(RefineFlippedCells, bool);
  vtkSetClampMacro(InterfaceLayers, int, 0, 64);
  vtkGetMacro(InterfaceLayers, int);
  ///@}

  ///@{
  /**
   * Cells that REFINEMENT_AUTOMATIC refines whatever they hold, by an array of one component and any numeric type: how
   * many times each cell is to be halved along every axis, a whole number from 0 to 10; 0/1 for a mask. A cell of the input is one
   * of its finest level there; of one that MaximumAspectRatio cuts each part is halved. MaximumLevel bounds what they get; at -1 there are
   * as many levels as they ask for. Cells are refined by families, 2 x 2 x 2 of a level that begin at even indices, and with
   * FineInterfaces off together with FineLayers of cells around. Blanked cells ask for nothing. All blocks need the array.
   * With ThinCells 0 nothing else is refined. Empty, or "None": no array. Default: empty.
   */
  vtkSetStdStringFromCharMacro(RefinementArray);
  vtkGetCharFromStdStringMacro(RefinementArray);
  ///@}

  ///@{
  /**
   * The same by a box in space from the corner (x0, y0, z0) to (x1, y1, z1), in the unit of the input: all cells that it reaches into
   * by more than a thousandth of their width along every axis, be their centres inside or not. A flat box chooses the cells that it cuts.
   * Where the array or several boxes choose a cell the most halvings count. Default: no box.
   */
  void AddRefinementBox(
    double x0, double y0, double z0, double x1, double y1, double z1, double halvings = 1.0);
  void ClearRefinementBoxes();
  int GetNumberOfRefinementBoxes();
  ///@}

  ///@{
  /**
   * Mesh the void too, as material 0. Default: off.
   */
  vtkSetMacro(MeshVoid, bool);
  vtkGetMacro(MeshVoid, bool);
  vtkBooleanMacro(MeshVoid, bool);
  ///@}

  ///@{
  /**
   * Turn cells into elements and move nothing. Default: off.
   */
  vtkSetMacro(StairStep, bool);
  vtkGetMacro(StairStep, bool);
  vtkBooleanMacro(StairStep, bool);
  ///@}

  enum SmoothingType
  {
    SMOOTHING_OFF = 0,
    SMOOTHING_QUADRIC_SURFACE = 1,
    SMOOTHING_GEOMETRY_BASED = 2
  };

  ///@{
  /**
   * How nodes on surfaces are placed. Default: SMOOTHING_QUADRIC_SURFACE.
   */
  vtkSetClampMacro(Smoothing, int, SMOOTHING_OFF, SMOOTHING_GEOMETRY_BASED);
  vtkGetMacro(Smoothing, int);
  ///@}

  enum SharpEdgesType
  {
    SHARP_EDGES_OFF = 0,
    SHARP_EDGES_ON = 1,
    SHARP_EDGES_AUTOMATIC = 2
  };

  ///@{
  /**
   * Whether edges and corners of the materials are found in the fractions and kept. Has an effect with an IsoValue of 0.5 and
   * SMOOTHING_QUADRIC_SURFACE alone. Default: SHARP_EDGES_AUTOMATIC.
   */
  vtkSetClampMacro(SharpEdges, int, SHARP_EDGES_OFF, SHARP_EDGES_AUTOMATIC);
  vtkGetMacro(SharpEdges, int);
  ///@}

  ///@{
  /**
   * The quality that smoothing strives for; in [0,1): the scaled Jacobian of hexahedra, for tetrahedra see
   * vtkVolumeFractionToTet. Larger values give better elements that follow the surfaces less closely.
   * 0: chosen automatically. Default: 0.
   */
  vtkSetMacro(TargetScaledJacobian, double);
  vtkGetMacro(TargetScaledJacobian, double);
  ///@}

  ///@{
  /**
   * Shift the surfaces until every material has the volume of its fractions. Default: on.
   */
  vtkSetMacro(ConserveVolume, bool);
  vtkGetMacro(ConserveVolume, bool);
  vtkBooleanMacro(ConserveVolume, bool);
  ///@}

  ///@{
  /**
   * Add the cell array ScaledJacobian. Default: on.
   */
  vtkSetMacro(ComputeQuality, bool);
  vtkGetMacro(ComputeQuality, bool);
  vtkBooleanMacro(ComputeQuality, bool);
  ///@}

  ///@{
  /**
   * Threads to work with. 0: all cores when there is one process, else one. Default: 0.
   * The mesh does not depend on it.
   */
  vtkSetClampMacro(NumberOfThreads, int, 0, VTK_INT_MAX);
  vtkGetMacro(NumberOfThreads, int);
  ///@}

  ///@{
  /**
   * The processes among which the input is distributed. Default: the global controller.
   */
  virtual void SetController(vtkMultiProcessController* controller);
  vtkGetObjectMacro(Controller, vtkMultiProcessController);
  ///@}

  ///@{
  /**
   * The processes across -x +x -y +y -z +z of this process' block, or -1 on the sides of the whole grid. Every
   * process then has one block and meshes its cells, and ghost cells come from the processes around, found from these six.
   * All processes must set them, or none. Default: not set, and the cells are shared out.
   */
  void SetFaceNeighbours(const int ranks[6]);
  void ClearFaceNeighbours();
  ///@}

protected:
  vtkVolumeFractionMeshAlgorithm();
  ~vtkVolumeFractionMeshAlgorithm() override;

  vtkExecutive* CreateDefaultExecutive() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation*, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  /**
   * Sets the kind of elements, and the options that this kind has alone.
   */
  virtual void SpecialiseOptions(vfm::MesherOptions& options) const = 0;

  vtkMultiProcessController* Controller = nullptr;
  std::vector<vfm::ChosenArray> VolumeFractionArrays;
  int WordAssociation = vfm::AnyAssociation; // of the words to come
  vfm::ChosenArray MaterialIdArray;
  std::vector<std::string> StateArrays;
  int StateTransfer = STATE_AUTOMATIC;
  std::vector<std::string> DensityArrays;
  std::vector<std::string> StateKinds; // words
  int StateOrder = 2;
  std::string VelocityArray, EnergyArray;
  bool NodalVelocity = false;
  int LostKineticEnergy = LOST_ENERGY_REPORT;
  int UnmeshedMaterial = UNMESHED_GIVE;
  double IsoValue = 0.5;
  double FractionTolerance = 1e-6;
  int LabelSmoothing = 0;
  std::string LabelNamesFile;
  int MinimumRegionCells = 0;
  int Refinement = REFINEMENT_INPUT_LEVELS;
  int MaximumLevel = -1;
  bool FineInterfaces = true;
  int FineLayers = 2;
  double MaximumAspectRatio = 0.0;
  int ChildFractions = CHILD_FRACTIONS_PLANES;
  double ThinCells = 2.0, CurvaturePerCell = 0.0;
  bool RefineFlippedCells = false;
  int InterfaceLayers = 0;
  std::string RefinementArray;
  std::vector<std::array<double, 7>> RefinementBoxes; // as AddRefinementBox takes them
  bool MeshVoid = false;
  bool StairStep = false;
  int Smoothing = SMOOTHING_QUADRIC_SURFACE;
  int SharpEdges = SHARP_EDGES_AUTOMATIC;
  double TargetScaledJacobian = 0.0;
  bool ConserveVolume = true;
  bool ComputeQuality = true;
  int NumberOfThreads = 0;
  bool HasFaceNeighbours = false;
  std::array<int, 6> FaceNeighbours{ { -1, -1, -1, -1, -1, -1 } };

private:
  vtkVolumeFractionMeshAlgorithm(const vtkVolumeFractionMeshAlgorithm&) = delete;
  void operator=(const vtkVolumeFractionMeshAlgorithm&) = delete;

  std::string GetNamedRefinementArray() const; // empty where none is used
  vfm::MaterialArrays FindMaterials(vtkDataObject* input, vfm::Ranks& ranks) const; // collective
  vfm::ArraysToRead ListArrays(
    const vfm::MaterialArrays& materials, const vfm::StateChoice& state) const;
  void PrintArrays(ostream& os, vtkIndent indent) const;
  bool IsStateConserved() const;
  vfm::StateChoice ChooseState(vtkDataObject* input, vfm::Ranks& ranks) const; // collective
  void SetStateOptions(vfm::MesherOptions& options) const;
  void SetRefinementOptions(vfm::MesherOptions& options) const;
  vfm::MesherOptions GetOptions() const;
  void Warn(const std::string& text, const vfm::Ranks& ranks) const;
  vfm::InputLevels FindLevels(
    vtkDataObject* input, const vfm::ArraysToRead& arrays, vfm::Ranks& ranks) const; // collective
  void Run(vtkDataObject* input, vfm::MessageRanks& ranks, const vfm::MeshOutputs& outputs);
};

#endif
