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
  /// Leave the mesh of an image with a direction matrix in the axes of the image, so that sides of
  /// the domain lie along x, y and z. Off: the mesh is turned to where the image lies in space.
  /// State arrays and refinement boxes are not turned. Takes on or off; default off.
  vfmSwitchOption(ImageAxes);
  /// Mesh the void as well, as material 0, conforming with the materials. Takes on or off; default
  /// off.
  vfmSwitchOption(MeshVoid);
  /// Remove spray, crumbs and small cavities: a region of one material, or of void, of fewer cells
  /// than this is given to the material or void with which it shares the most faces. 0: all stay.
  /// Takes a whole number, 0 or more; default 0.
  vfmNumberOption(MinimumRegionCells, int);
  /// Clip volume fractions that lie outside [0, 1] by no more than this (a code's over- and
  /// undershoots), and scale back sums above 1 by no more. Others are refused. 1e-6 is for rounding
  /// alone. Takes a number from 1e-6 to 0.1; default 1e-6.
  vfmNumberOption(FractionTolerance, double);
  /// A cell is void when its materials together fill less than this part of it. Volumes are
  /// conserved only at 0.5. Takes a number above 0 and below 1; default 0.5.
  vfmNumberOption(IsoValue, double);
  /// How elements get the values of state arrays. Copy: every element has the values of the cell
  /// that holds its centroid, or of the cell beside it with most of the element's material where
  /// that cell holds less than half. Nothing is averaged, so sums are not conserved. Conserve:
  /// elements share what the cells hold of their material, so that mass, momentum, energy of every
  /// material are those of the input. Automatic: Conserve where Density Arrays names one, else
  /// Copy. Takes Automatic, Copy, Conserve (or 0 to 2); default Automatic.
  vfmNumberOption(StateTransfer, int);
  /// What Conserve takes the state to be in a cell. 1: constant. 2: linear, within the bounds of
  /// the cells around. Takes a whole number from 1 to 2; default 2.
  vfmNumberOption(StateOrder, int);
  /// The velocity, of which Conserve tells momentum and kinetic energy of every material, and what
  /// the mesh lacks of it: an array of three components, or one of three (X velocity). Carried
  /// along as State Arrays are. Takes the name of a cell array, or None; default None.
  vfmArrayOption(VelocityArray);
  /// The internal energy per mass, of which Conserve tells the energy of every material. Of arrays
  /// a material any one. Carried along as State Arrays are. Takes the name of a cell array, or
  /// None; default None.
  vfmArrayOption(EnergyArray);
  /// Add the velocity of the nodes as a point array, with which a Lagrangian code starts. The
  /// momentum of all nodes is that of all elements. Takes on or off; default off.
  vfmSwitchOption(NodalVelocity);
  /// The kinetic energy that is lost where one element, or one node, moves with the mean velocity
  /// of several cells. Report: the table of materials tells it. Internal Energy: it is added to
  /// Energy Array, so that the sum of both energies is that of the input. Takes Report,
  /// InternalEnergy (or 0 to 1); default Report.
  vfmNumberOption(LostKineticEnergy, int);
  /// Material apart from all elements of its kind: spray, removed regions. Give: Conserve gives it
  /// to the nearest fragment of its material within a few cells. Drop: it is left out. What is left
  /// out the table of materials tells. Takes Give, Drop (or 0 to 1); default Give.
  vfmNumberOption(UnmeshedMaterial, int);
  /// Turn every cell of a material into one hexahedron and move nothing: a quick look at the
  /// materials. Takes on or off; default off.
  vfmSwitchOption(StairStep);
  /// How the nodes are placed. Quadric Surface: surface nodes follow smooth local quadrics of the
  /// surface; the best mesh. Geometry Based: surface nodes stay on the facets of the surface as
  /// first found. Off: the steps of the grid with a thin layer of hexahedra along them; valid, but
  /// neither smooth nor of good quality. Takes Off, QuadricSurface, GeometryBased (or 0 to 2);
  /// default QuadricSurface.
  vfmNumberOption(Smoothing, int);
  /// Whether edges and corners are found in the volume fractions and kept: those of machined parts,
  /// of shapes and of closed surfaces. Off: they are rounded, by about a third of a cell. On:
  /// wherever two or three surfaces that cut each other explain the fractions around better than
  /// one. Automatic: of two materials that meet, only where that is so in much of what one surface
  /// does not explain, so not in fluids and noise. Has an effect with Smoothing Quadric Surface and
  /// an IsoValue of 0.5 alone. Takes Off, On, Automatic (or 0 to 2); default Automatic.
  vfmNumberOption(SharpEdges, int);
  /// Smooth the steps that material ids make, by this many passes of an average over the cells
  /// around. Every material keeps the volume of its cells, thin parts stay. 2 or 3 serve most; more
  /// rounds off edges. Volume fractions are not smoothed. Takes a whole number from 0 to 10;
  /// default 0.
  vfmNumberOption(LabelSmoothing, int);
  /// Shift the surfaces until every fragment has the volume of its volume fractions. Takes on or
  /// off; default on.
  vfmSwitchOption(ConserveVolume);
  /// Where the mesh is finer than elsewhere; each level halves the cells. Input Levels: where the
  /// input is, if it has levels (AMR). Off: nowhere, all cells are those of the coarsest level.
  /// Automatic: where the shape needs it. Coarsen: the cells of the input stay near interfaces and
  /// get larger away from them. Uniform: everywhere, so that thin parts get more elements across.
  /// Takes Off, InputLevels, Automatic, Coarsen, Uniform (or 0 to 4); default InputLevels.
  vfmNumberOption(Refinement, int);
  /// Levels finer than the coarsest, at most. Automatic, -1: all that the input has; 1 where an
  /// image is refined, or what named cells ask for; by Coarsen as many as the numbers of cells
  /// allow, at most 3. By Uniform each makes eight times as many elements. Finer data of the input
  /// are averaged. Takes a whole number from -1 (automatic) to 10; default -1.
  vfmNumberOption(MaximumLevel, int);
  /// All interfaces get the finest cells. Off: cells are as fine as the levels of the input or the
  /// criteria ask at each place, and interfaces cross levels; by Coarsen all cells are then as
  /// coarse as can be. Hexahedra only: tetrahedra at interfaces are always fine. Takes on or off;
  /// default on.
  vfmSwitchOption(FineInterfaces);
  /// How many of the finest cells lie at least between an interface and larger cells. Without Fine
  /// Interfaces: around places where Automatic asks for them. Takes a whole number from 2 to 64;
  /// default 2.
  vfmNumberOption(FineLayers, int);
  /// Refinement Automatic halves cells at films, gaps, rods and small bodies thinner than so many
  /// cells. 0: it does not look for them. Takes a number from 0 (off) to 3; default 2.
  vfmNumberOption(ThinCells, double);
  /// Refinement Automatic halves cells where an interface turns by more than so many radians over a
  /// cell. 0: it does not look for that. Takes a number, 0 (off) or more; default 0.
  vfmNumberOption(CurvaturePerCell, double);
  /// Refinement Automatic halves cells once whose material had to be changed to make the interfaces
  /// manifold. Takes on or off; default off.
  vfmSwitchOption(RefineFlippedCells);
  /// Refinement Automatic refines all cells within so many layers of an interface, to Maximum
  /// Level. 0: it does not. Takes a whole number from 0 to 64; default 0.
  vfmNumberOption(InterfaceLayers, int);
  /// Cells that Refinement Automatic refines whatever they hold: the array that tells how many
  /// times each is to be halved, 0 to 10 (0 and 1 of a mask), up to Maximum Level. Thin Cells 0
  /// leaves these alone; without Fine Interfaces each place gets what it asks for. Takes the name
  /// of a cell array, or None; default None.
  vfmArrayOption(RefinementArray);
  /// Cut long cells (slices thicker than their pixels) across first, until no cell is so many times
  /// longer one way than another. 1.5 makes elements of good shape. 0: cells stay as they are.
  /// Takes 0 (off) or a number, 1.1 or more; default 0.
  vfmNumberOption(MaximumAspectRatio, double);
  /// What the halves, or parts, of a mixed cell hold where there is no finer data. Planes: the cell
  /// is cut by planes that keep the volume of every material. Parent: the fractions of the cell.
  /// Material ids hold no planes: their steps stay, unless Label Smoothing makes planes of them.
  /// Takes Planes, Parent (or 0 to 1); default Planes.
  vfmNumberOption(ChildFractions, int);
  /// The scaled Jacobian that smoothing strives for. Larger values give better hexahedra that
  /// follow the surfaces less closely. 0 is automatic: 0.55 with one material, 0.5 with several.
  /// Takes a number from 0 (automatic) to below 1; default 0.
  vfmNumberOption(TargetScaledJacobian, double);
  /// Add the cell array ScaledJacobian, and its minimum and mean to the field data. A cube has 1, a
  /// valid hexahedron more than 0. Takes on or off; default on.
  vfmSwitchOption(ComputeQuality);
  /// Threads to work with. 0 is automatic: all cores on one process, one thread on each of several.
  /// The mesh does not depend on it. Takes a whole number, 0 (automatic) or more; default 0.
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
