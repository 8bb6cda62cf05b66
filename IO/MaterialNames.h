/**
 * MaterialNames: what the field data of a mesh calls its materials.
 */
#pragma once

#include <map>
#include <string>

class vtkUnstructuredGrid;

namespace vfm
{

class MaterialNames
{
public:
  explicit MaterialNames(vtkUnstructuredGrid* mesh);
  /// Of a MaterialId; "Void" of 0, "Material 7" where there is no name.
  std::string Name(int material) const;
  /// By MaterialId, with that of void.
  const std::map<int, std::string>& All() const { return this->Names; }

private:
  std::map<int, std::string> Names;
};

} // namespace vfm
