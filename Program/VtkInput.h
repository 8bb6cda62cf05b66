/**
 * VtkInput: data of VTK's readers as an Input.
 */
#pragma once

#include "Input.h"

#include "vtkSmartPointer.h"

class vtkDataObject;
class vtkDataSet;

namespace vfm
{

/// Those with cells; data may be null.
std::vector<vtkDataSet*> GetGrids(vtkDataObject* data);

/// Collective. data: of this rank; the input keeps it, without a copy.
Input MakeInput(vtkSmartPointer<vtkDataObject> data, Ranks& ranks);

} // namespace vfm
