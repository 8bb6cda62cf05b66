/**
 * @class   vtkPVMaterialsInformation
 * @brief   transfers the names of materials from the server to the client
 *
 * The names come from the field data MaterialIds and MaterialNames of the output of a source,
 * filter or reader. The client writes them into legends.
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

  /// Reads the names from all output ports of an algorithm.
  void CopyFromObject(vtkObject* algorithm) override;
  void CopyToStream(vtkClientServerStream* stream) override;
  void CopyFromStream(const vtkClientServerStream* stream) override;

  /// Returns the names by id; empty if the data are not a mesh of this plugin.
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
