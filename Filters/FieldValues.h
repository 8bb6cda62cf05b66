/**
 * Numbers and texts of the mesher as arrays of VTK.
 */
#pragma once

#include "Input/FieldArray.h"

#include <vector>

class vtkFieldData;
class vtkTable;

namespace vfm
{

/// For scripts and files: hidden from lists of arrays, since views are not to offer them among those of cells and points.
void AddFields(const std::vector<FieldArray>& arrays, vtkFieldData* field);

void AddColumns(const std::vector<FieldArray>& arrays, vtkTable* table);

} // namespace vfm
