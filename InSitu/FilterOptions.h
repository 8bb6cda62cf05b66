/**
 * FilterOptions: the properties of the filters set by their names from text, for hosts and command lines.
 *
 * Names and words are taken in any case, with or without spaces; numbers are parsed whole, with a decimal point in
 * any locale. Of tetrahedra (vtkVolumeFractionToTet) there are more options than of hexahedra.
 */
#pragma once

#include "Options/MesherOptions.h"

#include <string>
#include <vector>

class vtkVolumeFractionMeshAlgorithm;

namespace vfm
{

/// Whether this mesher has an option of that name.
bool IsFilterOption(vtkVolumeFractionMeshAlgorithm& mesher, const std::string& name);

/// Throws InputError, which names the option, the value and what is allowed, when there is no such option, it is one of
/// tetrahedra only and the mesher is not, or the value is not allowed; the mesher is then as before.
void SetFilterOption(
  vtkVolumeFractionMeshAlgorithm& mesher, const std::string& name, const std::string& value);

/// For help, a line an option: its name, what it takes and its default.
std::vector<std::string> ListFilterOptions(vtkVolumeFractionMeshAlgorithm& mesher);

} // namespace vfm
