/**
 * @class   vtkSMMeshDomain
 * @brief   accepts input that the mesh writers of this project can write
 *
 * The input must have the arrays that these writers need: MaterialId and GlobalCellIds of cells,
 * and GlobalPointIds of points. The output of a filter that failed (FailedOutput.h) is accepted
 * too; the writer then reports the reason. If all ranks run the script (pvbatch --sym), each sees
 * its own piece; a mesh on one rank is enough, so that all ranks choose the same writer. The check
 * is collective in this mode.
 */
#ifndef vtkSMMeshDomain_h
#define vtkSMMeshDomain_h

#include "vtkSMDomain.h"
#include "vtkVolumeFractionMeshDomainsModule.h" // for export macro

class VTKVOLUMEFRACTIONMESHDOMAINS_EXPORT vtkSMMeshDomain : public vtkSMDomain
{
public:
  static vtkSMMeshDomain* New();
  vtkTypeMacro(vtkSMMeshDomain, vtkSMDomain);

  int IsInDomain(vtkSMProperty* property) override;

protected:
  vtkSMMeshDomain() = default;
  ~vtkSMMeshDomain() override = default;

private:
  vtkSMMeshDomain(const vtkSMMeshDomain&) = delete;
  void operator=(const vtkSMMeshDomain&) = delete;
};

#endif
