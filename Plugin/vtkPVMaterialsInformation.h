/**
 * The materials of the mesh that a source, filter or reader gave, as its field data name them (MaterialIds, MaterialNames):
 * what the client must know to write names into a legend, also of data that are on a server.
 */
#pragma once

#include "vtkPVInformation.h"

#include <map>
#include <string>

class vtkFieldData;

class vtkPVMaterialsInformation : public vtkPVInformation
{
public:
  static vtkPVMaterialsInformation* New();
  vtkTypeMacro(vtkPVMaterialsInformation, vtkPVInformation);

  /// Of any output port of an algorithm.
  void CopyFromObject(vtkObject* algorithm) override;
  void CopyToStream(vtkClientServerStream* stream) override;
  void CopyFromStream(const vtkClientServerStream* stream) override;

  /// Names by ids; none: no mesh of this plugin.
  const std::map<int, std::string>& GetNames() const { return this->Names; }

  vtkPVMaterialsInformation(const vtkPVMaterialsInformation&) = delete;
  void operator=(const vtkPVMaterialsInformation&) = delete;

protected:
  vtkPVMaterialsInformation();
  ~vtkPVMaterialsInformation() override = default;

private:
  bool CopyFromFieldData(vtkFieldData* field);

  std::map<int, std::string> Names;
};
