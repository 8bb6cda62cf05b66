/**
 * @class   vtkSMMeshDomain
 * @brief   whether the input is a mesh that writers of meshes can write
 *
 * It has the arrays that these writers need: MaterialId and GlobalCellIds of cells, GlobalPointIds of points. What a filter leaves where
 * no mesh could be made (FailedOutput.h) counts too: the writer tells why. Where ranks run the script alike (pvbatch --sym) and see their
 * own piece, one rank's mesh is enough, so that all take the same writer; they must ask together.
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
