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
 * On several ranks, rank 0 has the table and the others an empty one; all must update together.
 * Numbers do not depend on the number of ranks. A mesh without the required arrays gives one error
 * message on all ranks.
 */
#ifndef vtkVolumeFractionFragments_h
#define vtkVolumeFractionFragments_h

#include "vtkTableAlgorithm.h"
#include "vtkVolumeFractionMeshFiltersModule.h" // for export macro

#include <string> // for member
#include <vector> // for member

class vtkMultiProcessController;

class VTKVOLUMEFRACTIONMESHFILTERS_EXPORT vtkVolumeFractionFragments : public vtkTableAlgorithm
{
public:
  static vtkVolumeFractionFragments* New();
  vtkTypeMacro(vtkVolumeFractionFragments, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Cell arrays of mass per volume, for the column Mass: one for all materials, or one per material
   * in the order of the materials. The mesh has arrays that were StateArrays. Default: none.
   */
  void AddDensityArray(const char* name);
  void ClearDensityArrays();
  ///@}

  ///@{
  /**
   * Ranks that have pieces of the mesh. Default: the global controller.
   */
  virtual void SetController(vtkMultiProcessController* controller);
  vtkGetObjectMacro(Controller, vtkMultiProcessController);
  ///@}

protected:
  vtkVolumeFractionFragments();
  ~vtkVolumeFractionFragments() override;

  vtkExecutive* CreateDefaultExecutive() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation*, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  vtkMultiProcessController* Controller = nullptr;
  std::vector<std::string> DensityArrays;

private:
  vtkVolumeFractionFragments(const vtkVolumeFractionFragments&) = delete;
  void operator=(const vtkVolumeFractionFragments&) = delete;
};

#endif
