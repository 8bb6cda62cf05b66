/**
 * ExodusVariables: the arrays of a mesh as variables of Exodus, which have one number an item each.
 */
#pragma once

#include "vtkType.h"

#include <string>
#include <vector>

class vtkDataArray;
class vtkDataSetAttributes;
class vtkFieldData;

namespace vfm
{

struct ExodusVariable
{
  std::string Name;
  vtkDataArray* Array;
  int Component;
};

/// Of all numeric arrays but the global ids and the ghosts. A component of several has the ending that readers make vectors of
/// again: _X, _Y, _Z of up to three, else _1, _2, .. as wide as the last.
std::vector<ExodusVariable> ListVariables(vtkDataSetAttributes* data);

struct ExodusNumber
{
  std::string Name;
  double Value;
};

/// Of the numeric arrays of the field data with up to 100 numbers: NAME, or NAME_1, NAME_2, .. of several.
std::vector<ExodusNumber> ListNumbers(vtkFieldData* field);

} // namespace vfm
