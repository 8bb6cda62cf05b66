/**
 * @class   vtkVolumeFractionFragments
 * @brief   table of the fragments of a mesh
 *
 * Input: a mesh of vtkVolumeFractionToHex or vtkVolumeFractionToTet, also from a file.
 *
 * Output: one row per fragment, ordered by id, in the units of the mesh. Columns:
 * - FragmentId, MaterialId, Material (name), Elements
 * - FractionVolume: volume by the volume fractions; MeshVolume: volume of the elements
 * - CentroidX, CentroidY, CentroidZ, MinX, MaxX, MinY, MaxY, MinZ, MaxZ
 * - Mass, if there are densities
 * - Neighbours: ids of the fragments that share faces with it, separated by spaces
 *
 * On several ranks, rank 0 has a table of at most 100,000 rows and the others an empty one. A
 * longer table is in parts: the rows of a rank follow those of the rank before, and ranks may have
 * none (WholeTables). All ranks must update together. Numbers do not depend on the number of ranks.
 * FractionVolume exists if the field data of the mesh lists the volumes of all its fragments, on
 * any rank. A mesh without the required arrays gives one error message on all ranks.
 */
#ifndef vtkVolumeFractionFragments_h
#define vtkVolumeFractionFragments_h

#include "vtkVolumeFractionFilter.h"

#include <string> // for member
#include <vector> // for member

class vtkTable;

class VTKVOLUMEFRACTIONMESHFILTERS_EXPORT vtkVolumeFractionFragments :
  public vtkVolumeFractionFilter
{
public:
  static vtkVolumeFractionFragments* New();
  vtkTypeMacro(vtkVolumeFractionFragments, vtkVolumeFractionFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  vtkTable* GetOutput();

  ///@{
  /**
   * Cell arrays of mass per volume, for the column Mass: one for all materials, or one per material
   * in the order of the materials. The mesh has arrays that were StateArrays. Default: none.
   */
  void AddDensityArray(const char* name);
  void ClearDensityArrays();
  ///@}

  /// Whether rank 0 has the whole table. Allowed: Automatic (tables of at most 100,000 rows), Off,
  /// On (or 0 to 2); default Automatic. Otherwise each rank has a part of it.
  vfmNumberOption(WholeTables, int);

protected:
  vtkVolumeFractionFragments() = default;
  ~vtkVolumeFractionFragments() override = default;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  std::vector<std::string> DensityArrays;

private:
  vtkVolumeFractionFragments(const vtkVolumeFractionFragments&) = delete;
  void operator=(const vtkVolumeFractionFragments&) = delete;
};

#endif
