/**
 * @class   vtkVolumeFractionFragments
 * @brief   table of the fragments of a mesh
 *
 * Input: a mesh of vtkVolumeFractionToHex or vtkVolumeFractionToTet, also one read from a file. Output: a row a fragment, in the order of
 * their ids, with the columns FragmentId, MaterialId, Material, Elements, FractionVolume, MeshVolume, CentroidX, CentroidY, CentroidZ, MinX, MaxX,
 * MinY, MaxY, MinZ, MaxZ, Mass (when there are densities) and Neighbours (the fragments that share faces with it, blanks between). Lengths
 * are those of the mesh. FractionVolume is what the volume fractions ask of the fragment, MeshVolume what its elements have.
 *
 * Under MPI process 0 has the table, the others an empty one; all must update together. The numbers do not depend on the processes. A mesh without the arrays
 * gives one error message on all.
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
   * Cell arrays of mass per volume, for the column Mass: one for all materials, or one a material in the order of the
   * materials. The mesh has those that were among the StateArrays. Default: none.
   */
  void AddDensityArray(const char* name);
  void ClearDensityArrays();
  ///@}

  ///@{
  /**
   * The processes that have pieces of the mesh. Default: the global controller.
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
