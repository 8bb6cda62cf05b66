/**
 * LabelNameFields: names of labels as arrays of field data. Readers of images write them, and the
 * mesh filters use them as names of materials.
 */
#pragma once

#include "Input/LabelNames.h"

class vtkFieldData;

namespace vfm
{

/// Adds the arrays NamedLabels (int) and LabelNames (text), unless there are no names.
void AddLabelNames(const LabelNames& names, vtkFieldData* fields);

/// Returns the names of labels in the arrays NamedLabels and LabelNames; none if they are missing.
/// @param fields  field data of the input, may be null
LabelNames FindLabelNames(vtkFieldData* fields);

} // namespace vfm
