/**
 * VtkInput: converts the data of VTK's readers to an Input.
 */
#pragma once

#include "Input.h"

#include "vtkSmartPointer.h"

class vtkDataObject;
class vtkDataSet;

namespace vfm
{

/// Returns the data sets that have cells; data may be null.
std::vector<vtkDataSet*> GetGrids(vtkDataObject* data);

/// Makes an input of the data of this rank. The input refers to the data and keeps them alive.
/// @pre Collective
Input MakeInput(vtkSmartPointer<vtkDataObject> data, Ranks& ranks);

} // namespace vfm
