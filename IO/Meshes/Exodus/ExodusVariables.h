/**
 * ExodusVariables: lists the components of the arrays of a mesh as variables of Exodus.
 */
#pragma once

#include "Report/MeshData.h"

namespace vfm
{

/// Component of an array of points or elements.
struct ExodusVariable
{
  std::string Name;
  const MeshArray* Array;
  int Component;
};

/// Lists all components of all arrays, except global ids and ghost marks. Names of components have
/// endings from which readers form vectors: _X, _Y, _Z for up to three components, otherwise _1,
/// _2, ..., all of the same width.
/// @param arrays  arrays of points or elements; they must outlive the list
/// @param ids  values of the global ids, which may have any name
std::vector<ExodusVariable> ListVariables(const std::vector<MeshArray>& arrays, const void* ids);

/// Global variable.
struct ExodusNumber
{
  std::string Name;
  double Value;
};

/// Lists the numbers of all fields that have at most 100 numbers. The names are NAME, or NAME_1,
/// NAME_2, ... if a field has several numbers.
std::vector<ExodusNumber> ListNumbers(const std::vector<FieldArray>& fields);

} // namespace vfm
