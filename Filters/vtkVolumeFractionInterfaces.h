/**
 * @class   vtkVolumeFractionInterfaces
 * @brief   splits the interfaces of a mesh, and cuts layers along them
 *
 * Input: a mesh of vtkVolumeFractionToHex or vtkVolumeFractionToTet, also from a file, with its
 * arrays of ids, materials, fragments and geometry, and its field data. On several ranks each
 * element is on one rank.
 *
 * Port 0: the mesh that the mesher makes with the same options, bitwise: layers are cut first, then
 * interfaces are split. All arrays of the input follow. FirstLayer is in length units. Positions of
 * layers in a rotated image may differ by rounding.
 *
 * Port 1: the cohesive elements, as port 5 of the mesher.
 *
 * Elements of second order are not made here: their nodes on interfaces, also the corners, lie on
 * quadrics that are fitted to the volume fractions.
 *
 * A mesh without the required arrays, with split interfaces, with mid nodes, or for layers one of
 * tetrahedra, with layers, or without some of its parts, gives one error message on all ranks.
 */
#ifndef vtkVolumeFractionInterfaces_h
#define vtkVolumeFractionInterfaces_h

#include "vtkVolumeFractionFilter.h"

#include <string> // for member
#include <vector> // for member

class vtkUnstructuredGrid;

namespace vfm
{
class MessageRanks;
} // namespace vfm

class VTKVOLUMEFRACTIONMESHFILTERS_EXPORT vtkVolumeFractionInterfaces :
  public vtkVolumeFractionFilter
{
public:
  static vtkVolumeFractionInterfaces* New();
  vtkTypeMacro(vtkVolumeFractionInterfaces, vtkVolumeFractionFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  // options: generated
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
  /// Number of threads. 0 is automatic: all cores on one rank, one thread per rank on several. The
  /// mesh does not depend on it. Allowed: an integer, 0 (automatic) or more; default 0.
  vfmNumberOption(NumberOfThreads, int);
  // end of options

  ///@{
  /**
   * Cell arrays of type double whose values are sums over an element, such as a mass: layers share
   * them by volume. Layers have the values of all other arrays. Default: none.
   */
  void AddExtensiveArray(const char* name);
  void ClearExtensiveArrays();
  ///@}

protected:
  vtkVolumeFractionInterfaces();
  ~vtkVolumeFractionInterfaces() override = default;

  int RequestData(vtkInformation*, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  std::vector<std::string> ExtensiveArrays;

private:
  vtkVolumeFractionInterfaces(const vtkVolumeFractionInterfaces&) = delete;
  void operator=(const vtkVolumeFractionInterfaces&) = delete;

  void Run(vtkUnstructuredGrid* input, vfm::MessageRanks& ranks, vtkUnstructuredGrid* mesh,
    vtkUnstructuredGrid* cohesive);
};

#endif
