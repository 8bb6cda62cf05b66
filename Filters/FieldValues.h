/**
 * FieldValues: numbers and texts of the mesher as VTK arrays.
 */
#pragma once

#include "Input/FieldArray.h"

#include <vector>

class vtkFieldData;
class vtkTable;

namespace vfm
{

/// Adds field data for scripts and files, hidden from lists of cell and point arrays (GUI_HIDE).
void AddFields(const std::vector<FieldArray>& arrays, vtkFieldData* field);

/// Adds the columns of a table.
void AddColumns(const std::vector<FieldArray>& arrays, vtkTable* table);

} // namespace vfm
