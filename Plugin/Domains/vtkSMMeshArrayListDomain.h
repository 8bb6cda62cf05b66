/**
 * @class   vtkSMMeshArrayListDomain
 * @brief   the arrays of the input that can be meshed
 *
 * As vtkSMArrayListDomain, without arrays that mark ghosts and ids, and with point data of images alone, whose points are the centres of
 * cells. XML attribute role: "fractions" or "labels" of the property that takes such arrays. Of these the first choice is the array that
 * alone can hold the materials (MaterialGuess.h), in that role; of all others, and where there are several, none.
 * Two required properties with the functions Fractions and Labels, where one of them has a value already no choice is made.
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
   * Whether the property that a function names has a value that names an array.
   */
  bool IsChosen(const char* function);

  std::string Role;
};

#endif
