/**
 * ExodusVariables: the arrays of a mesh as variables of Exodus, which have one number per item.
 */
#pragma once

#include "Summary/MeshData.h"

namespace vfm
{

struct ExodusVariable
{
  std::string Name;
  const MeshArray* Array;
  int Component;
};

/// One per component of each array, except the global ids and the ghosts. Components have the endings that readers make vectors of
/// again: _X, _Y, _Z of up to three, else _1, _2, .. as wide as the last. ids: values of the global ids. The arrays must outlive
/// the list.
std::vector<ExodusVariable> ListVariables(const std::vector<MeshArray>& arrays, const void* ids);

struct ExodusNumber
{
  std::string Name;
  double Value;
};

/// The numbers of the fields with up to 100 numbers: NAME, or NAME_1, NAME_2, .. of several.
std::vector<ExodusNumber> ListNumbers(const std::vector<FieldArray>& fields);

} // namespace vfm
