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
#include <memory> // for member
#include <string> // for member
#include <vector> // for member

/**
 * Sets and gets an option of the mesher by its name (Mesher/Options/OptionTable.cxx). Choices and whole numbers, but for those of
 * tetrahedra, are clamped to their range; other numbers out of range are an error of the update.
 */
#define vfmNumberOption(name, type)                                                                \
  void Set##name(type value)                                                                       \
  {                                                                                                \
    this->SetNumber(#name, static_cast<double>(value));                                            \
  }                                                                                                \
  type Get##name()                                                                                 \
  {                                                                                                \
    return static_cast<type>(this->GetNumber(#name));                                              \
  }
#define vfmSwitchOption(name)                                                                      \
  vfmNumberOption(name, bool);                                                                     \
  void name##On()                                                                                  \
  {                                                                                                \
    this->Set##name(true);                                                                         \
  }                                                                                                \
  void name##Off()                                                                                 \
  {                                                                                                \
    this->Set##name(false);                                                                        \
  }
#define vfmArrayOption(name)                                                                       \
  void Set##name(const char* array)                                                                \
  {                                                                                                \
    this->SetText(#name, array);                                                                   \
  }                                                                                                \
  const char* Get##name()                                                                          \
  {                                                                                                \
    return this->GetText(#name);                                                                   \
  }

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
enum class ElementKind;
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
   * A file that names labels (MaterialIdArray), read by the first process: a text with a line for each, the label and its name, a label
   * file of ITK-SNAP, a lookup table of FreeSurfer or MRIcron, or the XML of an atlas of FSL. Labels that it does not name are
   * called "Material 7". Errors tell the line: no whole number, a label or a name twice. Default: none.
   */
  void SetLabelNamesFile(const char* path);
  const char* GetLabelNamesFile();
  ///@}

  ///@{
  /**
   * Cells that REFINEMENT_AUTOMATIC refines as by RefinementArray: those of a box in space from the corner (x0, y0, z0) to (x1, y1, z1), in the unit of the input: all cells that it reaches into
   * by more than a thousandth of their width along every axis, be their centres inside or not. A flat box chooses the cells that it cuts.
   * Where the array or several boxes choose a cell the most halvings count. Default: no box.
   */
  void AddRefinementBox(
    double x0, double y0, double z0, double x1, double y1, double z1, double halvings = 1.0);
  void ClearRefinementBoxes();
  int GetNumberOfRefinementBoxes();
  ///@}

  // What the numbers of options stand for.
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
    UNMESHED_DROP = 1
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
  /// Leave the mesh of an image with a direction matrix in the axes of the image. The sides of the
  /// domain then lie along x, y and z. Off: the mesh is rotated to the position of the image in
  /// space. State arrays and refinement boxes are not rotated. Allowed: on or off; default off.
  vfmSwitchOption(ImageAxes);
  /// Mesh the void as well, as material 0, conforming with the materials. Allowed: on or off;
  /// default off.
  vfmSwitchOption(MeshVoid);
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
  vfmArrayOption(VelocityArray);
  /// Internal energy per unit mass. Conserve preserves and reports it for each material. If every
  /// material has its own energy array, select any one of them. Transferred like State Arrays.
  /// Allowed: the name of a cell array, or None; default None.
  vfmArrayOption(EnergyArray);
  /// Add the velocity of the nodes as a point array, the initial state of a Lagrangian code. The
  /// momentum of all nodes equals the momentum of all elements. Allowed: on or off; default off.
  vfmSwitchOption(NodalVelocity);
  /// Treatment of the kinetic energy that is lost where one element, or one node, moves with the
  /// mean velocity of several cells. Report: the table of materials lists it. Internal Energy: it
  /// is added to Energy Array, so that the sum of both energies matches the input. Allowed: Report,
  /// InternalEnergy (or 0 to 1); default Report.
  vfmNumberOption(LostKineticEnergy, int);
  /// Treatment of material that is not attached to any element of its kind, such as small drops and
  /// removed regions. Give: Conserve adds it to the nearest fragment of its material within a few
  /// cells. Drop: it is left out. The table of materials lists how much is left out. Allowed: Give,
  /// Drop (or 0 to 1); default Give.
  vfmNumberOption(UnmeshedMaterial, int);
  /// Turn each cell of a material into one hexahedron and move no nodes: a quick preview of the
  /// materials. Allowed: on or off; default off.
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
  /// Smooth the steps of material ids, by this number of averaging passes over neighbour cells.
  /// Each material keeps the volume of its cells, and thin parts stay. 2 or 3 passes suit most
  /// images; more round off edges. Volume fractions are not smoothed. Allowed: an integer from 0 to
  /// 10; default 0.
  vfmNumberOption(LabelSmoothing, int);
  /// Shift the surfaces until each fragment has the volume given by its volume fractions. Allowed:
  /// on or off; default on.
  vfmSwitchOption(ConserveVolume);
  /// Where the mesh is refined; each level halves the cells. Input Levels: where the input has
  /// finer levels (AMR). Off: nowhere, all cells are of the coarsest level. Automatic: where the
  /// shape of the materials requires it. Coarsen: the cells of the input stay near interfaces and
  /// get larger away from them. Uniform: everywhere, so that thin parts get more elements across.
  /// Allowed: Off, InputLevels, Automatic, Coarsen, Uniform (or 0 to 4); default InputLevels.
  vfmNumberOption(Refinement, int);
  /// Maximum number of levels above the coarsest. Automatic (-1): all levels of the input, and for
  /// a refined image 1, or the levels that user-selected cells request. Coarsen then makes as many
  /// as the numbers of cells allow, up to 3. Uniform multiplies the number of elements by eight per
  /// level. Finer data of the input are averaged. Allowed: an integer from -1 (automatic) to 10;
  /// default -1.
  vfmNumberOption(MaximumLevel, int);
  /// All interfaces get the finest cells. Off: each place gets the level of the input or of the
  /// criteria there, and interfaces cross levels. With Coarsen all cells are then as coarse as
  /// possible. Hexahedra only: tetrahedra at interfaces are always of the finest cells. Allowed: on
  /// or off; default on.
  vfmSwitchOption(FineInterfaces);
  /// Minimum number of finest cells between an interface and larger cells. Without Fine Interfaces:
  /// number of fine cells around the places that Automatic refines. Allowed: an integer from 2 to
  /// 64; default 2.
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
  vfmArrayOption(RefinementArray);
  /// Divide cells of high aspect ratio first (slices thicker than their pixels), until no width of
  /// a cell exceeds another by more than this factor. 1.5 gives elements of good shape. 0: off.
  /// Allowed: 0 (off) or a number, 1.1 or more; default 0.
  vfmNumberOption(MaximumAspectRatio, double);
  /// Volume fractions in the halves, or parts, of a mixed cell where there are no finer data.
  /// Planes: the cell is cut by planes that preserve the volume of each material. Parent: the parts
  /// get the fractions of the cell. Material ids keep their steps with either choice, unless Label
  /// Smoothing is on. Allowed: Planes, Parent (or 0 to 1); default Planes.
  vfmNumberOption(ChildFractions, int);
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
  // end of options

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
  explicit vtkVolumeFractionMeshAlgorithm(vfm::ElementKind elements);
  ~vtkVolumeFractionMeshAlgorithm() override = 0; // an abstract class

  vtkExecutive* CreateDefaultExecutive() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation*, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  void SetNumber(const char* option, double value);
  double GetNumber(const char* option) const;
  void SetText(const char* option, const char* value);
  const char* GetText(const char* option) const;

  vtkMultiProcessController* Controller = nullptr;
  std::vector<vfm::ChosenArray> VolumeFractionArrays;
  int WordAssociation = vfm::AnyAssociation; // of the words to come
  vfm::ChosenArray MaterialIdArray;
  std::vector<std::string> StateArrays;
  std::unique_ptr<vfm::MesherOptions> Options;
  bool HasFaceNeighbours = false;
  std::array<int, 6> FaceNeighbours{ { -1, -1, -1, -1, -1, -1 } };

private:
  vtkVolumeFractionMeshAlgorithm(const vtkVolumeFractionMeshAlgorithm&) = delete;
  void operator=(const vtkVolumeFractionMeshAlgorithm&) = delete;

  vfm::MaterialArrays FindMaterials(vtkDataObject* input, vfm::Ranks& ranks) const; // collective
  void PrintArrays(ostream& os, vtkIndent indent) const;
  vfm::StateChoice ChooseState(vtkDataObject* input, vfm::Ranks& ranks) const; // collective
  void Warn(const std::string& text, const vfm::Ranks& ranks) const;
  vfm::InputLevels FindLevels(
    vtkDataObject* input, const vfm::ArraysToRead& arrays, vfm::Ranks& ranks) const; // collective
  void Run(vtkDataObject* input, vfm::MessageRanks& ranks, const vfm::MeshOutputs& outputs);
};

#endif
