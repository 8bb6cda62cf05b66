/**
 * @class   vtkSMMeshArrayListDomain
 * @brief   lists the arrays of the input that can be meshed
 *
 * Lists arrays as vtkSMArrayListDomain does, without ids and arrays that mark ghosts. Point data
 * are listed only for images, whose points are the centres of cells.
 *
 * The XML attribute role, "fractions" or "labels", selects a default: the array that holds the
 * materials in this role (ChooseMaterials.h), if no other array can hold materials.
 * The required properties with the functions Fractions and Labels disable the default if one of
 * them has a value.
 */
#ifndef vtkSMMeshArrayListDomain_h
#define vtkSMMeshArrayListDomain_h

#include "vtkSMArrayListDomain.h"
#include "vtkVolumeFractionMeshDomainsModule.h" // for export macro

#include <string> // for member

class VTKVOLUMEFRACTIONMESHDOMAINS_EXPORT vtkSMMeshArrayListDomain : public vtkSMArrayListDomain
{
public:
  static vtkSMMeshArrayListDomain* New();
  vtkTypeMacro(vtkSMMeshArrayListDomain, vtkSMArrayListDomain);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  int SetDefaultValues(vtkSMProperty* property, bool useUnchecked) override;

protected:
  vtkSMMeshArrayListDomain() = default;
  ~vtkSMMeshArrayListDomain() override = default;

  int ReadXMLAttributes(vtkSMProperty* property, vtkPVXMLElement* element) override;
  bool IsFilteredArray(vtkPVDataInformation* info, int association, const char* name) override;

private:
  vtkSMMeshArrayListDomain(const vtkSMMeshArrayListDomain&) = delete;
  void operator=(const vtkSMMeshArrayListDomain&) = delete;

  /**
   * Returns whether the required property with a function has an array.
   */
  bool IsChosen(const char* function);

  std::string Role;
};

#endif
