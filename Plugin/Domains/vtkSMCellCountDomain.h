/**
 * @class   vtkSMCellCountDomain
 * @brief   writes the number of cells that will be meshed into its property, before Apply
 *
 * The property is a text that the panel shows. It follows the values that the user enters in the
 * required property with the function Width, and the data of the one with the function Input. The
 * function Labels is the array of labels, which may be point data, and the function Spacing has the
 * widths of the cells of an image along its own axes; zeros: along those of the bounds.
 */
#ifndef vtkSMCellCountDomain_h
#define vtkSMCellCountDomain_h

#include "vtkSMDomain.h"
#include "vtkVolumeFractionMeshDomainsModule.h" // for export macro

class VTKVOLUMEFRACTIONMESHDOMAINS_EXPORT vtkSMCellCountDomain : public vtkSMDomain
{
public:
  static vtkSMCellCountDomain* New();
  vtkTypeMacro(vtkSMCellCountDomain, vtkSMDomain);

  void Update(vtkSMProperty* requesting) override;

protected:
  vtkSMCellCountDomain() = default;
  ~vtkSMCellCountDomain() override = default;

private:
  vtkSMCellCountDomain(const vtkSMCellCountDomain&) = delete;
  void operator=(const vtkSMCellCountDomain&) = delete;

  bool HasPoints(vtkPVDataInformation* info);
};

#endif
